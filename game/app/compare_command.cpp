// SPDX-License-Identifier: MIT
#include "game/app/commands.h"
#include "game/app/compare.h"

namespace sl {

void add_compare_command(const Flags& program) {
    auto flags = std::make_shared<CompareFlags>();
    const Flags command = program.command("compare", "Measure how far IMAGE is from REFERENCE: relMSE, NRMSE, 95th percentile, bias, FLIP");
    command.footer(
        "Two EXR files are compared in linear light, without the background (where the layer depth is 0); two PNG "
        "files\n"
        "are decoded first. Exit code: 0; 1 where a limit is exceeded or the input is bad; 2 for wrong flags.");
    command.add("IMAGE", flags->image, "EXR or PNG to judge").required();
    command.add("REFERENCE", flags->reference, "EXR or PNG that is right, of the same size").required();
    command.add("--layer", flags->layer,
                        "EXR layer of both files, '' for the unnamed one; default: irradiance where both have it, else "
                        "the unnamed one");
    command.add("--reference-layer", flags->reference_layer, "EXR layer of the reference where its name differs");
    command.toggle("--no-mask", flags->no_mask, "Compare the background too");
    command.add(
        "--ev100", flags->ev100,
        "Exposure of the pictures that FLIP sees of an EXR: values / (1.2 * 2^EV100), cut at 1, sRGB-encoded; "
        "default: the reference's mean becomes 18 % grey");
    command.add("--pixels-per-degree", flags->pixels_per_degree, "Of visual angle, for FLIP; 1 to 1000")
        ;
    command.add("--json", flags->json,
                        "Also write the figures into this file, as fractions; infinite ones become null");

    const Flag heat_map =
        command.add("--heat-map", flags->heat_map, "Write a PNG of the error per pixel, with a legend").group("Heat map");
    command.add("--heat", flags->heat, "What it shows: relative (error of luminance) or flip").one_of({"relative", "flip"}).needs(heat_map).group("Heat map");
    command.add("--heat-max", flags->heat_max,
            "Value at the bright end; default: 1 for flip, else a round value that 95 % of the pixels stay under").needs(heat_map).group("Heat map");

    const auto limit = [command](const char* name, std::optional<double>& value, const char* what) {
        command.add(name, value, what).not_negative().group("Limits (fractions: 0.05 is 5 %)");
    };
    limit("--max-relmse", flags->max_rel_mse, "Largest mean((x-r)^2 / (r^2 + (1 % of mean r)^2))");
    limit("--max-nrmse", flags->max_nrmse, "Largest root mean square error over the reference's mean");
    limit("--max-p95", flags->max_p95, "Largest relative error that 95 % of the pixels keep");
    limit("--max-bias", flags->max_bias, "Largest mean error over the reference's mean, too bright or too dark");
    limit("--max-flip", flags->max_flip, "Largest mean of FLIP, 0 to 1");
    command.runs([flags] { return run_compare(*flags); });
}

}  // namespace sl

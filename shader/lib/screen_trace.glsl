// SPDX-License-Identifier: MIT
// Follows a ray through what the camera sees. The includer declares `frame` and the sampler `depth`.

struct ScreenHit {
    vec2 uv;         // of the picture; where nothing was met, the last place on it
    float found;     // 0..1: less near the picture's edge, beyond which nothing is known
    float distance;  // m
};

const int screen_steps = 20;
const int screen_halvings = 4;
const float screen_growth = 1.35;  // of a step over the last

// xy: uv; z: how far the ray is behind what is drawn there, m along the view axis; w: its distance along the view axis.
vec4 screen_place(vec3 position) {
    vec4 clip = frame.clip_from_world * vec4(position, 1.0);
    vec2 uv = clip.xy / max(clip.w, 1e-6) * 0.5 + 0.5;
    float drawn = texture(depth, uv).r;
    return vec4(uv, clip.w - (drawn > 0.0 ? frame.camera_position.w / drawn : 1e9), clip.w);
}

// `first`: length of the first step, m; each is longer than the last. `thickness`, in steps: what is drawn is a
// shell so thick, and a ray farther behind it has passed it.
ScreenHit trace_screen(vec3 origin, vec3 direction, float first, float thickness) {
    ScreenHit hit = ScreenHit(screen_place(origin).xy, 0.0, 0.0);
    float before = 0.0;
    float step = first;
    for (int i = 0; i < screen_steps; ++i) {
        float now = before + step;
        vec4 place = screen_place(origin + direction * now);
        if (place.w <= frame.camera_position.w || any(greaterThan(abs(place.xy - 0.5), vec2(0.5)))) { return hit; }
        hit.uv = place.xy;
        hit.distance = now;
        if (place.z > 0.0 && place.z < thickness * step) {
            float near = before;
            float far = now;
            for (int halving = 0; halving < screen_halvings; ++halving) {
                float middle = 0.5 * (near + far);
                if (screen_place(origin + direction * middle).z > 0.0) { far = middle; } else { near = middle; }
            }
            hit.uv = screen_place(origin + direction * far).xy;
            hit.distance = far;
            vec2 inside = min(hit.uv, 1.0 - hit.uv);
            hit.found = clamp(min(inside.x, inside.y) * 12.0, 0.0, 1.0);
            return hit;
        }
        before = now;
        step *= screen_growth;
    }
    return hit;
}

package org.dronewatch.bvh;

import org.dronewatch.kdtree.SahCost;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.SettingsForm;

/**
 * How the trees for tracing rays are built from the models' triangles, and how rays traverse these trees. These
 * settings affect speed, not results.
 *
 * @param traversal method of traversal: {@code fastest}, or one ray at a time, even for images and sound ({@code stack}
 *     or {@code sequential})
 * @param costs costs that the surface area heuristic assumes for a traversal step and for a triangle test
 */
public record TracingSettings(RayTraversal traversal, SahCost costs) {
    /** The fastest traversal, with trees built with the library's costs. */
    public static final TracingSettings DEFAULT = new TracingSettings(RayTraversal.FASTEST, SahCost.DEFAULT);

    /** Checks that both are given. */
    public TracingSettings {
        Limits.check(TracingSettings.class, traversal, costs);
    }

    /** The default settings. */
    @Defaults
    public static TracingSettings standard() {
        return DEFAULT;
    }

    /** These settings with another traversal. */
    public TracingSettings withTraversal(RayTraversal other) {
        return SettingsForm.with(this, "traversal", other);
    }

    /** These settings with other costs. */
    public TracingSettings withCosts(SahCost other) {
        return SettingsForm.with(this, "costs", other);
    }
}

package org.dronewatch.bvh;

import org.dronewatch.kdtree.SahCost;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.SettingsForm;

/**
 * How the trees of the models' triangles are built, and how rays traverse them. These settings affect speed, not
 * results.
 *
 * @param traversal method of traversal: {@code fastest}, or one ray at a time, even for images and sound ({@code stack}
 *     or {@code sequential})
 * @param costs costs of a traversal step and of a triangle test assumed by the surface area heuristic
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

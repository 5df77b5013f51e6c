package org.dronewatch.render;

import java.util.Optional;
import org.dronewatch.render.canvas.SiteLines;
import org.dronewatch.setting.SettingsForm;

/**
 * The style of a picture: the parts of a site's state that are drawn, and their size.
 *
 * @param scale pixels of the picture per pixel of a screen of normal density: 2 on a screen of twice the density
 * @param labels whether sensors and drones are named
 * @param outlines whether fields of view are drawn
 * @param flights whether the paths of drones are drawn
 * @param filter filter for the rays of sound to be drawn
 * @param skin overlay on ground and roofs; empty for none
 * @param lines lines drawn in place of the paths of drones, if there are any
 */
public record SiteStyle(
        double scale,
        boolean labels,
        boolean outlines,
        boolean flights,
        RayFilter filter,
        Optional<SiteSkin> skin,
        SiteLines lines) {
    /** All parts, on a screen of normal density. */
    public static final SiteStyle DEFAULT = new SiteStyle(1.0, true, true, true, RayFilter.ALL);

    /** A style without a skin and without lines. */
    public SiteStyle(double scale, boolean labels, boolean outlines, boolean flights, RayFilter filter) {
        this(scale, labels, outlines, flights, filter, Optional.empty(), SiteLines.NONE);
    }

    /** This style with another {@link #scale}. */
    public SiteStyle withScale(double density) {
        return SettingsForm.with(this, "scale", density);
    }

    /** This style with or without names. */
    public SiteStyle withLabels(boolean shown) {
        return SettingsForm.with(this, "labels", shown);
    }

    /** This style with or without fields of view. */
    public SiteStyle withOutlines(boolean shown) {
        return SettingsForm.with(this, "outlines", shown);
    }

    /** This style with or without the paths of drones. */
    public SiteStyle withFlights(boolean shown) {
        return SettingsForm.with(this, "flights", shown);
    }

    /** This style with another filter for the rays of sound. */
    public SiteStyle withFilter(RayFilter other) {
        return SettingsForm.with(this, "filter", other);
    }

    /** This style with another skin, or with none. */
    public SiteStyle withSkin(Optional<SiteSkin> other) {
        return SettingsForm.with(this, "skin", other);
    }

    /** This style with other lines. */
    public SiteStyle withLines(SiteLines others) {
        return SettingsForm.with(this, "lines", others);
    }
}

package org.dronewatch.render;

/**
 * What of a site's state is drawn, and how large.
 *
 * @param scale pixels of the picture for one of a screen of normal density: 2 on a screen of twice the density
 * @param labels whether sensors and drones are named
 * @param outlines whether it shows what sensors look into
 * @param flights whether the ways of drones are drawn
 * @param filter which rays of sound are drawn
 */
public record SiteStyle(double scale, boolean labels, boolean outlines, boolean flights, RayFilter filter) {
    /** All of it on a screen of normal density. */
    public static final SiteStyle DEFAULT = new SiteStyle(1.0, true, true, true, RayFilter.ALL);

    /** This style on a screen of another density. */
    public SiteStyle withScale(double density) {
        return new SiteStyle(density, labels, outlines, flights, filter);
    }

    /** This style with or without names. */
    public SiteStyle withLabels(boolean shown) {
        return new SiteStyle(scale, shown, outlines, flights, filter);
    }

    /** This style with or without what sensors look into. */
    public SiteStyle withOutlines(boolean shown) {
        return new SiteStyle(scale, labels, shown, flights, filter);
    }

    /** This style with or without the ways of drones. */
    public SiteStyle withFlights(boolean shown) {
        return new SiteStyle(scale, labels, outlines, shown, filter);
    }

    /** This style with other rays of sound. */
    public SiteStyle withFilter(RayFilter other) {
        return new SiteStyle(scale, labels, outlines, flights, other);
    }
}

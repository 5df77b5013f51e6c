package org.dronewatch.picture;

/**
 * Which pieces of rays are drawn.
 *
 * @param fewest surfaces that their ray has met before, from this on
 * @param most surfaces that their ray has met before, up to this
 * @param heardOnly only paths that reached the sensor
 */
public record RayFilter(int fewest, int most, boolean heardOnly) {
    /** All of them. */
    public static final RayFilter ALL = new RayFilter(0, Integer.MAX_VALUE, false);

    /** Whether a piece is drawn. */
    public boolean shows(RaySet rays, int piece) {
        int order = rays.order(piece);
        return order >= fewest && order <= most && (!heardOnly || rays.isHeard(piece));
    }

    /** How many pieces are drawn. */
    public int count(RaySet rays) {
        int shown = 0;
        for (int i = 0; i < rays.count(); i++) {
            shown += shows(rays, i) ? 1 : 0;
        }
        return shown;
    }
}

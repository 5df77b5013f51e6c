package org.dronewatch.report.route;

import java.awt.Color;
import org.dronewatch.route.RoutePoint;

/**
 * How exposed a drone is on a piece of a route, in classes of the chance that it is detected within a second: from
 * light and thin to dark and thick, so that the classes keep their order in black and white and for the colour-blind.
 */
enum RouteColours {
    /** Nothing detects it. */
    NONE("none", 0.0, new Color(0x8fd8ff), 3f),
    /** It is hardly detected. */
    LOW("up to 1 %", 0.01, new Color(0xfee08b), 4f),
    /** It is detected sooner or later. */
    MEDIUM("up to 20 %", 0.2, new Color(0xf46d43), 5.5f),
    /** It is detected at once. */
    HIGH("more than 20 %", 1.0, new Color(0x6a0d5e), 7f);

    private final String words;
    private final double most;
    private final Color colour;
    private final float width;

    RouteColours(String words, double most, Color colour, float width) {
        this.words = words;
        this.most = most;
        this.colour = colour;
        this.width = width;
    }

    /** The class of a piece between two points. */
    static RouteColours of(RoutePoint from, RoutePoint to) {
        double time = to.time() - from.time();
        double rate = time > 0.0 ? (to.exposure() - from.exposure()) / time : 0.0;
        double chance = -Math.expm1(-rate);
        for (RouteColours one : values()) {
            if (chance <= one.most) {
                return one;
            }
        }
        return HIGH;
    }

    /** The chance in words. */
    String words() {
        return words;
    }

    Color colour() {
        return colour;
    }

    /** The width of a line, pixels. */
    float width() {
        return width;
    }
}

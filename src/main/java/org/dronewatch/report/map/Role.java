package org.dronewatch.report.map;

import java.util.Locale;

/** The role of a feature on a map: it determines its folder and the size of its marker. */
enum Role {
    /** Where a sensor is. */
    SENSOR("Sensors", Size.LARGE),
    /** The field of view of a sensor. */
    FIELD("Fields of view", Size.MEDIUM),
    /** A protected zone. */
    ZONE("Protected zones", Size.LARGE),
    /** The path of a drone. */
    FLIGHT("Flights", Size.MEDIUM),
    /** The path of a bird. */
    BIRD("Birds", Size.SMALL),
    /** Where a drone was at its alert. */
    ALERT("Alerts", Size.LARGE),
    /** Where a drone was when a sensor detected it. */
    GAINED("Detections", Size.MEDIUM),
    /** Where a drone was when a sensor lost it. */
    LOST("Detections", Size.SMALL),
    /** The outline of a building. */
    BUILDING("Buildings", Size.SMALL),
    /** A gap in the coverage at a height. */
    GAP("Gaps", Size.MEDIUM);

    /** Width of lines in pixels. */
    static final double STROKE = 2.0;

    /** The opacity of areas, 0 to 1: they lie over one another and over the map. */
    static final double OPACITY = 0.15;

    private final String folder;
    private final Size size;

    Role(String folder, Size size) {
        this.folder = folder;
        this.size = size;
    }

    /** The title of its folder. */
    String folder() {
        return folder;
    }

    /** The size of its marker. */
    Size size() {
        return size;
    }

    /** Whether the role has a folder only if a feature is in it: many scenes have no such feature. */
    boolean isRare() {
        return this == BUILDING || this == BIRD || this == GAP;
    }

    /** Whether its name is written on the map: the names of a hundred detections would cover one another. */
    boolean isNamed() {
        return this != GAINED && this != LOST && this != BUILDING;
    }

    /** Sizes of markers. */
    enum Size {
        SMALL(0.6),
        MEDIUM(0.9),
        LARGE(1.2);

        private final double scale;

        Size(double scale) {
            this.scale = scale;
        }

        /** The size as a fraction of a map's usual marker. */
        double scale() {
            return scale;
        }

        /** The word for this size in simplestyle. */
        String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }
}

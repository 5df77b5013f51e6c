package org.dronewatch.placement;

import org.dronewatch.LongForm;

/**
 * Candidates of placement files round the zone of {@link org.dronewatch.analysis.field.FieldSite}: radars of two kinds
 * that see all around, but not through boxes; how likely they detect the drone depends on its range.
 */
public final class RadarCandidates {
    private static final String CANDIDATES =
            """
            candidates:
              radar:
                sensor: {kind: radar, minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 0.03 Hz, minSpeed: 0.1 m/s,
                  budget: {range: 130, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
                price: 2
                places: [%s]
              small:
                sensor: {kind: radar, minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 0.02 Hz, minSpeed: 0.1 m/s,
                  budget: {range: 100, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
                price: 1
                places: [%s]
            """;

    /** Two places for each kind. */
    public static final String FOUR = CANDIDATES.formatted("[0, 90, 4], [0, -95, 4]", "[0, 0, 4], [-50, -50, 4]");

    /** Three places for each kind. */
    public static final String SIX =
            CANDIDATES.formatted("[0, 90, 4], [0, -95, 4], [-55, 10, 17]", "[0, 0, 4], [60, 0, 4], [-50, -50, 4]");

    /** The airspace in which routes past them are compared. */
    public static final String AIR = air(40);

    /** The same in larger cells, except in the long form: a search takes a third of the time. */
    public static final String COARSE_AIR = air(LongForm.count(60, 40));

    private RadarCandidates() {}

    private static String air(int cell) {
        return "air: {side: 240 m, cell: %d m, heights: [30 m]}\n".formatted(cell);
    }
}

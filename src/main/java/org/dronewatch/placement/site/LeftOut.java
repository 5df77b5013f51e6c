package org.dronewatch.placement.site;

/** What a time limit may cut short or prevent, besides a search for layouts. */
public enum LeftOut {
    /** What the layout and the scene's own sensors cover at each height. */
    COVERAGE,
    /** The warning times of the layout and of the scene's own sensors, by height. */
    WARNINGS,
    /** What parts of the layout and the scene's own sensors achieve, and the order in which to buy. */
    PARTS,
    /** The flights along the weakest routes past the layout and past the scene's own sensors. */
    FLIGHTS,
    /** The attacks on the layout and on the scene's own sensors. */
    ATTACKS
}

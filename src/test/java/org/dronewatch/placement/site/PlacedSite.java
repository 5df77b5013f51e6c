package org.dronewatch.placement.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.analysis.field.FieldSite;

/** A placement file for the plain with four boxes: 14 candidates of three kinds. */
public final class PlacedSite {
    private static final String CANDIDATES =
            """
            scene: site.yaml
            candidates:
              radar:
                sensor: {kind: radar, minRange: 1, maxRange: 150, elevationWidth: 90 deg, minSpeed: 3 m/s,
                  budget: {range: 5000, crossSection: 0.01}}
                price: 2
                places: [[0, 0, 4], [100, 100, 4], {east: -85 m, north: -10 m, above: 2 m}]
              radio:
                sensor: {kind: rf, threshold: 12}
                price: 1.5
                line: {from: [-135, 0], to: [165, 0], every: 50 m, above: 3 m}
              eye:
                sensor: {kind: camera, fov: 40 deg, width: 800, height: 600}
                price: 1
                places: [[0, 0, 30]]
                aims: 4
            air: {side: 400 m, cell: 80 m, heights: [10 m, 40 m]}
            """;

    private PlacedSite() {}

    /**
     * Writes the site, with one radar of its own, and the file.
     *
     * @param more lines of the file: the budget, and perhaps conditions
     */
    public static Path in(Path directory, String more) throws IOException {
        FieldSite.in(directory, FieldSite.ROUND);
        return Files.writeString(directory.resolve("radars.place.yaml"), CANDIDATES + more);
    }
}

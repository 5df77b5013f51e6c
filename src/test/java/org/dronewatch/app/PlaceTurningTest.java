package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;

/**
 * The layout has a camera on a positioner, which turns to what a radar reports or searches: other commands give, for
 * its scene, the figures that {@code place} promised.
 */
class PlaceTurningTest {
    /** All numbers in files have six decimals. */
    private static final double ROUNDING = 1e-6;

    private static final String CANDIDATES =
            """
            scene: site.yaml
            budget: 4
            candidates:
              camera:
                sensor: {kind: camera, fov: 24 deg, width: 640, height: 480, rate: RATE, aim: {azimuth: 0 deg, elevation: 5 deg}}
                price: 1
                places: [[3, 0, 34], [-50, -50, 34]]
                positioners: {turning: {positioner: {search: {kind: round}}, price: 2}}
              radar:
                sensor: {kind: radar, minRange: 1, maxRange: 400, elevationWidth: 90 deg, minSpeed: 0.1 m/s,
                  rate: RATE, budget: {range: 60, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
                price: 1
                places: [[0, 0, 4]]
            """;

    @TempDir
    private Path directory;

    private PlacedLayout place(String rate, String more) throws IOException {
        FieldSite.in(directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        Path file = Files.writeString(directory.resolve("turning.place.yaml"), CANDIDATES.replace("RATE", rate) + more);
        PlacedLayout place = PlacedLayout.of(file, directory, "--budgets=1");
        assertThat(place.promised().get("chosen"))
                .anyMatch(sensor -> sensor.get("sensor").asString().endsWith("turning"));
        return place;
    }

    @ParameterizedTest
    @ValueSource(strings = {"cued", "search"})
    void coverage(String pointing) throws IOException {
        PlacedLayout place = place(
                "2 Hz",
                "air: {side: 400 m, cell: 40 m, heights: [40 m], heading: inbound, covered: 0.02, within: 60 s, pointing: "
                        + pointing + "}\n");
        double covered = place.coveredShare();

        assertThat(covered).isBetween(0.1, 0.999);
        assertThat(place.promised().get("value").asDouble()).isCloseTo(covered, within(ROUNDING));
    }

    @Thorough
    @ParameterizedTest
    @ValueSource(strings = {"cued", "search"})
    void weakestRoute(String pointing) throws IOException {
        PlacedLayout place = place(
                "0.05 Hz",
                "objective: weakest-route\nair: {side: 240 m, cell: 80 m, heights: [40 m], pointing: " + pointing
                        + "}\n");
        JsonNode routes =
                place.json("route", "--out=" + directory.resolve("routes")).get("routes");
        double least = Double.MAX_VALUE;
        for (int sector = 0; sector < routes.size(); sector++) {
            JsonNode route = routes.get(sector);
            least = Math.min(least, route.get("upper").asDouble());
            assertThat(place.promised().get("flown").get(sector).get("layout").asDouble())
                    .isCloseTo(route.get("p_detect").asDouble(), within(ROUNDING));
        }

        assertThat(routes.size()).isEqualTo(8);
        assertThat(least).isBetween(0.001, 13.0);
        assertThat(place.promised().get("value").asDouble()).isCloseTo(least, within(1e-3 * least + ROUNDING));
    }
}

package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.RadarCandidates;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What placements for warnings and against routes print of the layout is what other commands find for its scene. */
class PlaceObjectivesTest {
    private static final String CANDIDATES = "scene: site.yaml\nbudget: 3\n" + RadarCandidates.FOUR;

    @TempDir
    private Path directory;

    private PlacedLayout place(String more) throws IOException {
        return placed(CANDIDATES + more);
    }

    private PlacedLayout placed(String file) throws IOException {
        FieldSite.in(directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        return PlacedLayout.of(Files.writeString(directory.resolve("ring.place.yaml"), file), directory.resolve("."));
    }

    private JsonNode json(String name) {
        return JsonMapper.builder().build().readTree(directory.resolve(name).toFile());
    }

    private void assertFrontAndPictures(String... pictures) throws IOException {
        JsonNode front = json("place.json").get("front");
        assertThat(front.size()).isGreaterThan(1);
        for (int step = 1; step < front.size(); step++) {
            for (String key : List.of("cost", "value")) {
                assertThat(front.get(step).get(key).asDouble())
                        .isGreaterThan(front.get(step - 1).get(key).asDouble());
            }
        }
        assertThat(front.get(front.size() - 1).get("value"))
                .isEqualTo(json("place.json").get("value"));
        String page = Files.readString(directory.resolve("report.html"));
        assertThat(page).contains("<h2>What more money buys</h2>", "The best layout that was found has ");
        assertThat(page.split("<figure>")).hasSize(2 + pictures.length);
        for (String name : pictures) {
            assertThat(ImageIO.read(directory.resolve(name).toFile())).isNotNull();
        }
        assertThat(ImageIO.read(directory.resolve("front.png").toFile())).isNotNull();
    }

    @Test
    void theRoutesPastTheLayoutAreThoseOfRoute() throws IOException {
        assumeTrue(LongForm.IS_ON, "flies eight routes from eight moments three times");
        PlacedLayout place = place("objective: weakest-route\nair: {side: 240 m, cell: 40 m, heights: [30 m]}\n");
        assertFrontAndPictures("routes.png", "routes-today.png");
        place.again("route", "--out=" + directory.resolve("routes"));

        JsonNode flown = json("place.json").get("flown");
        JsonNode routes = json("routes/route.json").get("routes");
        assertThat(flown.size()).isEqualTo(8);
        assertThat(routes.size()).isEqualTo(8);
        assertThat(json("place.json").get("value").asDouble())
                .isCloseTo(json("routes/route.json").get("least_exposure").asDouble(), within(1e-6));
        for (int sector = 0; sector < 8; sector++) {
            assertThat(flown.get(sector).get("sector"))
                    .isEqualTo(routes.get(sector).get("sector"));
            assertThat(flown.get(sector).get("layout").asDouble())
                    .isCloseTo(routes.get(sector).get("p_detect").asDouble(), within(1e-9));
        }
        assertThat(place.outcome().out())
                .contains("Past the layout, on the weakest route, the drone comes from the ")
                .contains("Past today's sensors, on the weakest route, the drone comes from the ");
    }

    /**
     * The ring lies between the middles of cells: flights show that it detects the drone on the route that the search
     * finds first, and others take its place. The search promises no more than on that route.
     */
    @Thorough
    @Test
    void theExposureOnARouteThatFlightsReplaceIsThatOfRoute() throws IOException {
        PlacedLayout place = placed(
                """
                scene: site.yaml
                objective: weakest-route
                budget: 3
                candidates:
                  ring:
                    sensor: {kind: radar, minRange: 45, maxRange: 74, elevationWidth: 90 deg, rate: 0.5 Hz, minSpeed: 0 m/s,
                      budget: {range: 5000, crossSection: 0.01}}
                    price: 1
                    places: [[15, 30, 4]]
                  radar:
                    sensor: {kind: radar, minRange: 1, maxRange: 300, elevationWidth: 90 deg, rate: 0.03 Hz, minSpeed: 0 m/s,
                      budget: {range: 90, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
                    price: 2
                    places: [[-63, -1, 6], [-46, -62, 3]]
                air: {side: 360 m, cell: 50 m, heights: [20 m]}
                """);
        JsonNode promised = place.promised();
        JsonNode routes = place.json("route", "--out=" + directory.resolve("routes"));
        double value = promised.get("value").asDouble();

        assertThat(promised.get("chosen")).hasSize(2);
        assertThat(routes.get("routes"))
                .allSatisfy(route -> assertThat(route.get("upper").asDouble()).isGreaterThan(2.0 * value));
        assertThat(routes.get("least_exposure").asDouble()).isCloseTo(value, within(1e-3 * value));
        assertThat(promised.get("route").get("exposure").asDouble()).isEqualTo(value);
        assertThat(place.outcome().out())
                .contains(
                        "By the search alone, the least exposed route comes from the north, with a counted exposure of ");
    }

    /** A route that was found past other sensors is weaker past the layout than those that a search past it finds. */
    @Test
    void theExposureOnARouteOfAnotherLayoutIsPromised() throws IOException {
        assumeTrue(LongForm.IS_ON, "takes half a minute");
        PlacedLayout place = placed(
                """
                scene: site.yaml
                objective: weakest-route
                budget: 6
                candidates:
                  radar:
                    sensor: {kind: radar, minRange: 1, maxRange: 150, elevationWidth: 90 deg, rate: 0.1 Hz, minSpeed: 0.1 m/s,
                      budget: {range: 60, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
                    price: 2
                    places: [[-19, 106, 6], [-106, 30, 6], [-17, -14, 17], [105, -108, 6]]
                air: {side: 300 m, cell: 30 m, heights: [8 m, 20 m]}
                """);
        JsonNode promised = place.promised();
        JsonNode routes = place.json("route", "--out=" + directory.resolve("routes"));

        assertThat(promised.get("route").get("exposure")).isEqualTo(promised.get("value"));
        assertThat(promised.get("value").asDouble())
                .isLessThan(0.999 * routes.get("least_exposure").asDouble());
        assertThat(place.outcome().out())
                .contains("A search with this layout alone finds no route with an exposure below 0.388; but on a route"
                        + " that was found with other sensors, the exposure to this layout is even lower: 0.386.");
    }

    /** Each radar sees half of the directions: one alone warns of nothing from the others. */
    @Test
    void purchasesThatGainNothingUntilAnotherAreNamed() throws IOException {
        PlacedLayout place = placed(
                """
                scene: site.yaml
                objective: warning-time
                warning: worst
                budget: 4
                candidates:
                  half:
                    sensor: {kind: radar, minRange: 1, maxRange: 150, azimuthWidth: 200 deg, elevationWidth: 90 deg, minSpeed: 3 m/s,
                      budget: {range: 5000, crossSection: 0.01}}
                    price: 2
                    places: [[-55, 10, 17]]
                    aims: 2
                air: {side: 400 m, cell: 20 m, heights: [12 m, 40 m]}
                """);
        String sentence = "The first purchase gains nothing until half-1-";

        assertThat(place.promised().get("chosen")).hasSize(2);
        assertThat(place.promised().get("value").asDouble()).isPositive();
        assertThat(place.outcome().out()).contains(sentence);
        assertThat(Files.readString(directory.resolve("report.html")))
                .contains(sentence, "Since only the worst case counts, which the first sensors may not improve,");
    }

    @Test
    void theWarningsOfTheLayoutAreThoseOfCoverage() throws IOException {
        PlacedLayout place = place("objective: warning-time\nwarning: mean\n"
                + "air: {side: 400 m, cell: 20 m, heights: [12 m, 40 m], covered: 0.1}\n");
        assertFrontAndPictures("warnings.png", "warnings-today.png");
        Outcome coverage = place.again("coverage");
        String warnings = "warning of drones that fly straight in";

        String ofLayout = place.outcome().out().substring(place.outcome().out().lastIndexOf(warnings));
        assertThat(coverage.out()).contains(ofLayout.lines().limit(4).collect(Collectors.joining("\n")));
        assertThat(place.outcome().out()).contains("today:", "layout:");
    }
}

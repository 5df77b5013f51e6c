package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.placement.route.RoutePlacement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

/**
 * Radars that look every 10 s only, and see the drone for 2 s before it is too late for the response: the search, which
 * lets them look at any moment, expects much more of them than flights show.
 */
class PlaceFlownTest {
    @TempDir
    private Path directory;

    private static final String SLOW =
            "{kind: radar, minRange: 1, maxRange: 100, elevationWidth: 90 deg, rate: 0.1 Hz, minSpeed: 0 m/s,\n"
                    + "      budget: {range: 5000, crossSection: 0.01}}";

    private PlacedLayout placed(String more) throws IOException {
        site("");
        return placed(SLOW, more);
    }

    /** The scene, whose drone has another setting. */
    private void site(String drone) throws IOException {
        FieldSite.in(
                directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 15], radius: 30}, response: 4 s}\n");
        Path site = directory.resolve("site.yaml");
        Files.writeString(site, Files.readString(site).replace("    soundLevel: 38\n", "    soundLevel: 38\n" + drone));
    }

    private PlacedLayout placed(String radar, String more) throws IOException {
        Path file = Files.writeString(
                directory.resolve("here.place.yaml"),
                """
                scene: site.yaml
                objective: weakest-route
                budget: 3
                candidates:
                  slow:
                    sensor: %s
                    price: 1
                    places: [[0, 0, 45], [4, 0, 45]]
                air: {side: 240 m, cell: 20 m, heights: [30 m]}
                """
                                .formatted(radar)
                        + more);
        return PlacedLayout.of(file, directory, "--budgets=1");
    }

    @Thorough
    @Test
    void whatFlightsShowComesFirst() throws IOException {
        PlacedLayout place = placed("");
        JsonNode flown = place.promised().get("flown");
        double least = IntStream.range(0, flown.size())
                .mapToDouble(sector -> flown.get(sector).get("layout").asDouble())
                .min()
                .orElseThrow();
        JsonNode weakest = place.promised().get("weakest_flown");
        double estimated =
                RoutePlacement.detection(place.promised().get("value").asDouble());
        String first = String.format(
                Locale.ROOT,
                "As flown, the layout detects the drone in time with a probability of only %.1f %% on the weakest route"
                        + " past it, from the %s; the search estimates %.1f %%, because it assumes that 'slow-",
                100.0 * least,
                weakest.get("sector").asString(),
                100.0 * estimated);

        assertThat(estimated).isGreaterThan(least + 0.5);
        assertThat(weakest.get("p_in_time").asDouble()).isEqualTo(least);
        assertThat(place.outcome().out().lines().findFirst().orElseThrow()).startsWith(first);
        assertThat(place.outcome().out())
                .contains("By this estimate, no layout within the budget has", "As flown, another may do better.");
        assertThat(verdict())
                .startsWith("The best layout that was found has 2 sensors for 2 EUR. " + first)
                .contains("as flown, another may.");
    }

    /** Without either radar, the search still expects more than half of the drones to be detected in time. */
    @Thorough
    @Test
    void whatFlightsShowOfALossIsStated() throws IOException {
        PlacedLayout place = placed("conditions: {anyoneLost: {atLeast: 0.5}}\n");
        JsonNode chosen = place.promised().get("chosen");
        JsonNode losses = place.promised().get("flown_losses");

        assertThat(chosen).hasSize(2).allSatisfy(one -> assertThat(
                        RoutePlacement.detection(one.get("without").asDouble()))
                .isGreaterThan(0.5));
        assertThat(losses).hasSize(2);
        for (JsonNode loss : losses) {
            JsonNode others = place.json(
                            "route", "--set", "sensors." + loss.get("sensor").asString() + ".enabled=false")
                    .get("routes");
            double least = IntStream.range(0, others.size())
                    .mapToDouble(route -> others.get(route).get("p_in_time").asDouble())
                    .min()
                    .orElseThrow();
            assertThat(loss.get("p_in_time").asDouble()).isLessThan(0.5).isCloseTo(least, within(1e-6));
        }
        String words = "If slow-1 or slow-2 is lost, the layout detects the drone with a probability of ";
        assertThat(place.outcome().out())
                .containsPattern("(?m)^" + words
                        + ".*, as estimated by the search\\. In flights past the layout without each of these"
                        + " sensors in turn, the worst case is the loss of slow-.*: the drone is then detected in time with a"
                        + " probability of .*, on the route from the .*\\. This is less than the 0\\.5 that"
                        + " conditions\\.anyoneLost\\.atLeast asks for\\.$");
        assertThat(verdict()).contains(words, "In flights past the layout without each of these sensors in turn");
    }

    /**
     * Radars that do not see the north, which the drone has too little endurance to fly around to: this gap makes all
     * layouts worthless, though it is the only one.
     */
    @Thorough
    @Test
    void theGapThatNothingClosesIsNamed() throws IOException {
        site("    performance: {endurance: 14 s}\n");
        PlacedLayout place = placed(
                "{kind: radar, minRange: 1, maxRange: 400, azimuthWidth: 290 deg, elevationWidth: 90 deg, minSpeed: 0 m/s,\n"
                        + "      aim: {azimuth: 180 deg}, budget: {range: 5000, crossSection: 0.01}}",
                "");
        JsonNode remaining = place.promised().get("remaining");
        Map<Boolean, List<String>> directions = new HashMap<>();
        remaining.forEach(route -> directions
                .computeIfAbsent(route.get("exposure").asDouble() == 0.0, open -> new ArrayList<>())
                .add(route.get("sector").asString()));
        List<String> open = directions.get(true);
        JsonNode points = remaining.get(0).get("points");
        String begins = String.format(
                Locale.ROOT,
                "%.1f, %.1f, %.1f",
                points.get(0).get("x").asDouble(),
                points.get(0).get("y").asDouble(),
                points.get(0).get("z").asDouble());
        String gap =
                "Even past both affordable candidates together, a route remains on which no sensor detects the drone"
                        + " in time; the route begins at " + begins + " (east, north, up; m), in the north, ";
        String others =
                "From the east, south-east, south, south-west and west, both affordable candidates together detect";

        assertThat(place.promised().get("chosen")).isEmpty();
        assertThat(open).containsExactlyInAnyOrder("north", "north-east", "north-west");
        assertThat(directions.get(false))
                .containsExactlyInAnyOrder("east", "south-east", "south", "south-west", "west");
        assertThat(place.outcome().out())
                .contains("Buying nothing would do as well", "\n" + gap, "\n" + others)
                .containsPattern("(?m)^north +0\\.0 % +0\\.0 % +- +- +-$");
        assertThat(verdict())
                .contains("Today's sensor detects", gap, "That route leads through " + begins + "; ", others);
        assertThat(directory.resolve("front.png")).doesNotExist();
        assertThat(directory.resolve("routes-today.png")).isNotEmptyFile();
    }

    private String verdict() throws IOException {
        Matcher verdict = Pattern.compile("class=\"verdict\">(.*?)</p>")
                .matcher(Files.readString(directory.resolve("report.html")));
        assertThat(verdict.find()).isTrue();
        return verdict.group(1);
    }
}

package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.LongForm;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.route.WeakestRouteSearch;
import org.dronewatch.placement.site.CoveredCells;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.setting.Quantity;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

/** In Monaco: the chosen layout, run by other commands, gives the figures that {@code place} promised. */
class PlaceMonacoTest {
    /** All numbers in files have six decimals. */
    private static final double ROUNDING = 1e-6;

    /** What a placement may have at most: cells, counting each height, the gap, and the time until it is reached, s. */
    private static final long MOST_CELLS = 250_000;

    private static final double MOST_GAP = 0.05;
    private static final double MOST_SECONDS = 300.0;

    private static final Path SCENES = Path.of("scenes");

    @TempDir
    private Path directory;

    @BeforeEach
    void copyScene() throws IOException {
        assumeTrue(LongForm.IS_ON, "assesses 17 candidates over Monaco");
        Files.copy(SCENES.resolve("palace.yaml"), directory.resolve("palace.yaml"));
        Files.copy(SCENES.resolve("two-radars.campaign.yaml"), directory.resolve("attacks.campaign.yaml"));
    }

    /** Runs the packaged placement with other lines in place of its conditions and its airspace. */
    private PlacedLayout place(String lines, String... more) throws IOException {
        List<String> options = new ArrayList<>(List.of("--budgets=1"));
        options.addAll(List.of(more));
        return place(lines, start -> start, options.toArray(String[]::new));
    }

    /** The same with a change of what precedes these lines, and all options. */
    private PlacedLayout place(String lines, UnaryOperator<String> change, String... options) throws IOException {
        String packaged = Files.readString(SCENES.resolve("palace.place.yaml"));
        String start = change.apply(packaged.substring(0, packaged.indexOf("conditions:")));
        Path file = Files.writeString(directory.resolve("here.place.yaml"), start + lines);
        return PlacedLayout.of(file, directory, options);
    }

    @Test
    void coverage() throws IOException {
        PlacedLayout place = place("air: {side: 1500 m, cell: 75 m, heights: [30 m, 60 m, 120 m], heading: inbound}\n");
        double covered = place.coveredShare();

        assertThat(covered).isBetween(0.5, 0.999);
        assertThat(place.promised().get("value").asDouble()).isCloseTo(covered, within(ROUNDING));
    }

    @Test
    void warnings() throws IOException {
        for (String measure : List.of("mean", "worst")) {
            PlacedLayout place = place("objective: warning-time\nwarning: " + measure
                    + "\nair: {side: 1500 m, cell: 25 m, heights: [30 m, 60 m, 120 m]}\n");
            double sum = 0.0;
            double least = Double.MAX_VALUE;
            JsonNode flights = place.json("coverage").get("warning");
            for (JsonNode flight : flights) {
                double time = flight.get("warning_s").isNull()
                        ? 0.0
                        : flight.get("warning_s").asDouble();
                sum += time;
                least = Math.min(least, time);
            }

            assertThat(flights.size()).isEqualTo(place.promised().get("flights").asInt());
            assertThat(place.promised().get("value").asDouble())
                    .isCloseTo(measure.equals("mean") ? sum / flights.size() : least, within(ROUNDING));
            assertThat(sum).isPositive();
        }
    }

    /**
     * The page's example: the exposure before which there is time to respond, as the search promises it, and as the
     * routes are flown; and the figures that the page states.
     */
    @Test
    void weakestRoute() throws IOException {
        PlacedLayout place = placeAgainstRoutes(true);
        JsonNode found = place.json("route", "--out=" + directory.resolve("routes"));
        JsonNode routes = found.get("routes");
        double least = found.get("least_exposure").asDouble();
        List<String> others = new ArrayList<>();
        for (int sector = 0; sector < routes.size(); sector++) {
            JsonNode route = routes.get(sector);
            JsonNode flown = place.promised().get("flown").get(sector);
            assertThat(route.get("upper").asDouble()).isGreaterThanOrEqualTo(least);
            assertThat(flown.get("sector")).isEqualTo(route.get("sector"));
            assertThat(flown.get("layout").asDouble())
                    .isCloseTo(route.get("p_in_time").asDouble(), within(ROUNDING));
            if (!flown.get("sector").asString().equals("east")) {
                others.add(flown.get("sector").asString());
            }
        }
        JsonNode promised = place.promised();

        assertThat(routes.size()).isEqualTo(8);
        assertThat(promised.get("route").get("exposure").asDouble()).isCloseTo(least, within(1e-3 * least + ROUNDING));
        assertThat(promised.get("value").asDouble())
                .isCloseTo(Math.min(least, WeakestRouteSearch.ENOUGH), within(1e-3 * least + ROUNDING));

        String page = page();
        assertThat(place.outcome().out()).contains("(exposure 13.8 or more)", " in the east, ");
        assertThat(page).contains("from the east, the exposure is 13.8 or more");
        assertThat(place.outcome().out()).containsPattern(row("east", "> 99\\.9 %"));
        others.forEach(from -> assertThat(place.outcome().out()).containsPattern(row(from, "100\\.0 %")));
        assertThat(page).contains("a probability of > 99.9 % from there and 100.0 % from\nthe seven other directions");
        assertThat(promised.get("chosen"))
                .hasSize(2)
                .allMatch(one -> one.get("kind").asString().equals("rf"));
        assertThat(page)
                .contains(String.format(
                        Locale.ROOT,
                        "two of them, for %,d,",
                        promised.get("cost").asInt()));
        assertThat(promised.get("present").get("sensors").asInt()).isEqualTo(4);
        assertThat(promised.get("present").get("value").asDouble()).isZero();
        assertThat(page).contains("Past the four radars of the scene, a route remains on which none of them detects");
        assertThat(promised.get("front")).hasSize(1);
        assertThat(page)
                .contains(String.format(
                        Locale.ROOT,
                        "every layout for less than %,d leaves a gap",
                        promised.get("cost").asInt()));
    }

    private static Pattern row(String from, String flown) {
        return Pattern.compile("(?m)^" + from + " .* " + flown + " +\\d+\\.\\d s$");
    }

    private static String page() throws IOException {
        return Files.readString(Path.of("src", "site", "markdown", "placement.md"));
    }

    /** With the receivers where the packaged placement has them, nothing detects the drone on a route from the east. */
    @Test
    void nothingIsBoughtThatGainsNothing() throws IOException {
        PlacedLayout place = placeAgainstRoutes(false);

        assertThat(page()).contains("buying nothing would do as well: a route from the east remains past every layout");
        assertThat(place.outcome().out())
                .contains("Buying nothing would do as well")
                .containsPattern("Even past all 17 affordable candidates together, a route remains .* in the east, ");
        assertThat(place.promised().get("value").asDouble()).isZero();
        assertThat(place.promised().get("chosen")).isEmpty();
    }

    /** With the lines of the page; on request, receivers are on its other line. */
    private PlacedLayout placeAgainstRoutes(boolean isEast) throws IOException {
        Matcher lines = Pattern.compile("(?m)^    (objective: weakest-route)\\n    (air: .*)\\n")
                .matcher(page());
        assertThat(lines.find()).isTrue();
        Matcher line = Pattern.compile("(?m)^    (line: .*)$").matcher(page().substring(lines.end()));
        assertThat(line.find()).isTrue();
        return place(
                lines.group(1) + "\n" + lines.group(2) + "\n",
                start -> isEast ? start.replaceFirst("(?m)line: \\{.*$", line.group(1)) : start,
                "--budgets=12");
    }

    /**
     * 200 candidates of eight kinds, in as many cells as are asked for: {@code -Ddronewatch.cell=8m} makes 250,000 of
     * them, which takes long. Once the candidates have been assessed, the command reaches a gap below 5 % in less than
     * five minutes on two threads.
     */
    @Test
    void twoHundredCandidates() throws IOException {
        Path file = Files.copy(SCENES.resolve("monaco.place.yaml"), directory.resolve("monaco.place.yaml"));
        String cell = System.getProperty("dronewatch.cell", "40m");
        String[] options = {"--cell=" + cell, "--gap=0.05", "--budgets=1", "--threads=2"};
        // Elsewhere, tests keep nothing.
        System.setProperty(
                StorePlace.PROPERTY,
                Files.createDirectory(directory.resolve("cache")).toString());
        JsonNode found = PlacedLayout.of(file, directory, options).promised();
        long elapsed = System.nanoTime();
        long processor = processorTime();
        PlacedLayout place = PlacedLayout.of(file, directory, options);
        double seconds = 1e-9 * (System.nanoTime() - elapsed);
        PlacePlan plan = PlacePlan.read(file, runner -> {}, note -> {}).withCell(Quantity.LENGTH.parse(cell));
        FieldGrid grid = new CoveredCells(plan, plan.runner().stage(plan.present()), LayerStore.NONE).grid();
        long cells = (long) grid.cells() * grid.heights().size();
        System.out.printf(
                Locale.ROOT,
                "200 candidates, %d cells, assessed before: gap %.4f after %.1f s, %.1f s of processor time%n",
                cells,
                found.get("gap").asDouble(),
                seconds,
                1e-9 * (processorTime() - processor));
        double covered = place.coveredShare();

        assertThat(plan.candidates()).hasSize(200);
        assertThat(plan.settings().candidates()).hasSize(8);
        assertThat(place.promised()).isEqualTo(found);
        assertThat(found.get("complete").asBoolean()).isTrue();
        assertThat(cells).isBetween(10_000L, MOST_CELLS);
        assertThat(found.get("gap").asDouble()).isBetween(0.0, MOST_GAP).isNotEqualTo(MOST_GAP);
        assertThat(seconds).isLessThan(MOST_SECONDS);
        assertThat(found.get("value").asDouble()).isGreaterThan(0.9);
        assertThat(place.outcome().out())
                .contains(String.format(Locale.ROOT, "the layout covers %.1f %% of the known cells", 100.0 * covered));
    }

    @AfterEach
    void keepNothing() {
        System.clearProperty(StorePlace.PROPERTY);
    }

    private static long processorTime() {
        return ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class).getProcessCpuTime();
    }

    /** The page's example: the same attacks against the layout and against the four radars of today. */
    @Test
    void attacks() throws IOException {
        String packaged = Files.readString(SCENES.resolve("palace.place.yaml"));
        PlacedLayout place = place(
                packaged.substring(packaged.indexOf("conditions:")),
                "--campaign=" + directory.resolve("attacks.campaign.yaml"),
                "--runs=200");
        JsonNode again = place.json("compare");
        JsonNode attacks = place.promised().get("campaign");

        assertThat(attacks.get("variants").get("layout"))
                .isEqualTo(again.get("variants").get("layout"));
        assertThat(attacks.get("variants").get("today"))
                .isEqualTo(again.get("variants").get("palace"));
        String page = page();
        Matcher shares = Pattern.compile("\\d+\\.\\d \\(\\d+\\.\\d to \\d+\\.\\d\\)$", Pattern.MULTILINE)
                .matcher(place.outcome().out());
        assertThat(shares.results())
                .hasSize(2)
                .allMatch(share -> page.contains(share.group().replaceFirst(" ", " % ")));
        assertThat(page)
                .contains(place.outcome()
                        .out()
                        .lines()
                        .filter(line -> line.startsWith("in time: layout minus today"))
                        .map(line -> line.replaceFirst(".* today = ", "").replaceFirst("\\), .*", ")"))
                        .findFirst()
                        .orElseThrow());
    }
}

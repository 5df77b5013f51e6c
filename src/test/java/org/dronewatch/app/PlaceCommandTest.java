package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.dronewatch.LongForm;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The best layout before a plain with four boxes, as the command prints and writes it. */
class PlaceCommandTest {
    @TempDir
    private static Path directory;

    private static Path file;
    private static Outcome outcome;
    private static JsonNode json;

    @BeforeAll
    static void run() throws IOException {
        file = PlacedSite.in(directory, "budget: 6\nkeep: [round]\n");
        outcome = place(file, "--threads=1", "--out=" + directory.resolve("."));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        json = JsonMapper.builder()
                .build()
                .readTree(directory.resolve("place.json").toFile());
    }

    private static Outcome place(Path from, String... more) {
        List<String> words = new ArrayList<>(List.of("place", from.toString()));
        words.addAll(List.of(more));
        return Program.run(words.toArray(String[]::new));
    }

    @Test
    void theFileStatesTheLayoutAndWhatLessMoneyBuys() {
        assertThat(json.propertyNames())
                .containsExactly(
                        "objective",
                        "value",
                        "bound",
                        "gap",
                        "cost",
                        "chosen",
                        "silent_drone",
                        "present",
                        "front",
                        "budgets",
                        "worst_heading",
                        "heights",
                        "complete");
        assertThat(json.get("objective").asString()).isEqualTo("coverage");
        assertThat(json.get("complete").asBoolean()).isTrue();
        assertThat(json.get("bound").asDouble())
                .isGreaterThanOrEqualTo(json.get("value").asDouble());
        assertThat(json.get("gap").asDouble()).isBetween(0.0, 0.001);
        assertThat(json.get("cost").asDouble()).isLessThanOrEqualTo(6.0);
        assertThat(json.get("present").get("sensors").asInt()).isEqualTo(1);
        assertThat(json.get("chosen").get(0).get("sensor").asString()).isEqualTo("round");
        JsonNode front = json.get("front");
        assertThat(front.size()).isBetween(2, 12);
        JsonNode last = front.get(front.size() - 1);
        assertThat(last.get("value").asDouble()).isCloseTo(json.get("value").asDouble(), within(1e-9));
        assertThat(last.get("cost").asDouble()).isEqualTo(json.get("cost").asDouble());
        for (int step = 0; step < front.size(); step++) {
            assertThat(front.get(step).propertyNames())
                    .containsExactly("cost", "budget", "value", "bound", "gap", "added", "removed");
            assertThat(front.get(step).get("added").size()).isPositive();
        }
        // Beginning with the sensor that is kept, the steps lead to the layout.
        Set<String> names = new TreeSet<>(Set.of("round"));
        for (JsonNode step : front) {
            assertThat(step.get("bound").asDouble())
                    .isGreaterThanOrEqualTo(step.get("value").asDouble());
            step.get("removed").forEach(one -> names.remove(one.asString()));
            step.get("added").forEach(one -> names.add(one.asString()));
        }
        Set<String> chosen = new TreeSet<>();
        json.get("chosen").forEach(one -> chosen.add(one.get("sensor").asString()));
        assertThat(names).isEqualTo(chosen);
        for (int step = 1; step < front.size(); step++) {
            for (String key : List.of("cost", "value")) {
                assertThat(front.get(step).get(key).asDouble())
                        .isGreaterThan(front.get(step - 1).get(key).asDouble());
            }
        }
    }

    /** The figures of the third table, and of the sentence above the tables. */
    @Test
    void theFileStatesTheCoverageAtEachHeight() {
        assertThat(outcome.out())
                .contains("On the heading that is worst in each cell, the layout covers "
                        + percent(json.get("worst_heading")) + " %");
        assertThat(json.get("heights")).hasSize(2);
        for (JsonNode height : json.get("heights")) {
            JsonNode layout = height.get("layout");
            JsonNode present = height.get("present");
            assertThat(outcome.out())
                    .containsPattern(" " + height.get("height_m").asInt() + " m +"
                            + percent(present.get("covered_share")) + " +" + percent(layout.get("covered_share"))
                            + " +" + percent(present.get("after_loss_share")) + " +"
                            + percent(layout.get("after_loss_share")) + " +" + hectares(present) + " +"
                            + hectares(layout) + "\n");
        }
    }

    private static String percent(JsonNode share) {
        return String.format(Locale.ROOT, "%.1f", 100.0 * share.asDouble());
    }

    private static String hectares(JsonNode layout) {
        return String.format(
                Locale.ROOT, "%.1f", 1e-4 * layout.get("largest_gap_m2").asDouble());
    }

    @Test
    void theReportHasWhatIsPrintedAndThePicturesOfEachHeight() throws IOException {
        String page = Files.readString(directory.resolve("report.html"));

        assertThat(page)
                .contains("<h2>What to buy</h2>", "<h2>What more money buys</h2>", "<h2>Coverage by height</h2>")
                .contains("<h2>If a sensor fails</h2>", "The best layout that was found has ", "kept</td>");
        Matcher change = Pattern.compile("\\S+; (closes|adds most in) the .*").matcher(outcome.out());
        assertThat(change.results().map(MatchResult::group))
                .hasSize(json.get("front").size())
                .allMatch(page::contains);
        for (String name :
                List.of("front", "layout-10", "layout-40", "today-10", "today-40", "change-10", "change-40")) {
            assertThat(ImageIO.read(directory.resolve(name + ".png").toFile())).isNotNull();
        }
        assertThat(page.split("<figure>")).hasSize(6);
    }

    /** With no money there is no layout to draw, nor anything to plot, but the report still says so. */
    @Test
    void withoutMoneyTheLayoutIsEmpty(@TempDir Path other) throws IOException {
        Outcome empty = place(PlacedSite.in(other, "budget: 0\n"), "--out=" + other.resolve("."));

        assertThat(empty.code()).as(empty.err()).isZero();
        assertThat(empty.out())
                .contains("The layout covers 0.0 % of the airspace")
                .doesNotContain("best layout for each");
        assertThat(Files.readString(other.resolve("report.html")))
                .contains("No sensor that the budget allows covers")
                .doesNotContain("front.png");
        assertThat(other.resolve("layout-10.png")).doesNotExist();
        assertThat(other.resolve("front.png")).doesNotExist();
    }

    @Test
    void theLayoutIsASceneThatRuns() throws IOException {
        Outcome run = Program.run("check", directory.resolve("layout.yaml").toString());

        assertThat(run.code()).as(run.err()).isZero();
        String scene = Files.readString(directory.resolve("layout.yaml"));
        json.get("chosen").forEach(sensor -> assertThat(scene)
                .contains(sensor.get("sensor").asString() + ":"));
    }

    @Test
    void anyNumberOfThreadsGivesTheSameBytes() throws IOException {
        place(file, "--threads=3", "--out=" + directory.resolve("again"));

        assertThat(directory.resolve("again/place.json")).hasSameBinaryContentAs(directory.resolve("place.json"));
    }

    @Test
    void itPrintsWhatTheLayoutIsWorth() {
        assertThat(outcome.out())
                .contains("best layout from 15 candidates for a budget of 6 EUR, judged by its coverage averaged over"
                        + " eight headings, in order of purchase:")
                .contains("The layout covers ")
                .contains("The scene's own sensor covers ")
                .contains(", whose loss is worst, the layout covers ")
                .contains("best layout for each budget, costs in EUR, judged by its coverage averaged over eight")
                .contains("coverage on the heading that is worst in each cell");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "budget: -1                                       | ': budget -1 must be 0 to 1e12'",
                "budget: 1e400                                    | ': budget 1e400 must be 0 to 1e12'",
                "budget: 1 and: more                              | 'unknown'",
                "keep: [x]                                        | 'keep: there is no enabled sensor ''x'''",
                "drone: two                                       | 'drone two: there is no such drone'",
                "objective: money                                 | 'objective: ''money'' is not one of [coverage, warning-time, weakest-route]'",
                "conditions: {anyoneLost: {atLeast: 1}}           | 'budget 1: no layout was found that keeps to it'",
                "air: {cell: 1 m}                                 | 'air.cell: 500 x 500 cells at 5 heights on 8 headings'",
                "air: {covered: 0.999}                            | 'air.covered: 0.999: must be 0.008 to 0.996, or 1'",
                "air: {side: 10 m, cell: 50 m}                    | 'air: a cell of 50.0 m is longer than the side of the area'",
                "conditions: {fold: 0}                            | 'fold 0 must be 1 to 10'",
                "objective: weakest-route                         | 'objective weakest-route: the scene protects no zone'",
                "objective: warning-time                          | 'objective warning-time: the scene protects no zone'",
                "warning: best                                    | 'warning: ''best'' is not one of [worst, mean]'",
                "conditions: {anyoneLost: {warning: 20 s}}        | 'conditions.anyoneLost: must have only ''atLeast'''",
                "conditions: {base: [0, 0, -5]}                  | 'candidates.radar: none of its places has a line of sight'",
                "air: {area: yard}                               | 'air.area yard: no such zone; the scene protects nothing'",
                "objective: weakest-route and fold                | 'conditions.fold: has no meaning for the objective'",
            })
    void namesWhatIsWrong(String line, String message) throws IOException {
        Path bad = directory.resolve("bad.place.yaml");
        String good = Files.readString(file)
                .replaceAll("(?m)^(budget|keep" + (line.startsWith("air") ? "|air" : "") + "):.*\n", "");
        String lines = line.replace(" and fold", "\nconditions: {fold: 2}");
        Files.writeString(bad, good + (line.startsWith("budget") ? "" : "budget: 1\n") + lines + "\n");
        Outcome refused = place(bad, "--out=" + directory.resolve("refused"));

        assertThat(refused.code()).as(refused.err()).isEqualTo(2);
        assertThat(refused.err())
                .contains(message.replace("unknown", "bad.place.yaml:"))
                .doesNotContain("\tat ", "budget: budget");
        assertThat(directory.resolve("refused")).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource({
        "-5, must be 0 to 1e12",
        "1e400, must be 0 to 1e12",
        "2e12, must be 0 to 1e12",
        "much, must be a number without a unit",
        "5 EUR, must be a number without a unit"
    })
    void namesTheBudgetThatIsNone(String budget, String message) {
        Outcome refused = place(file, "--budget=" + budget);

        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.err().strip()).isEqualTo("--budget " + budget + ": " + message);
    }

    /** The losses that count in the search stand beside those on the worst heading; each figure says which it is. */
    @Test
    void theReportSaysWhichHeadingCounts() throws IOException {
        String page = Files.readString(directory.resolve("report.html"));

        assertThat(page)
                .containsPattern("class=\"verdict\">[^<]* of the airspace, averaged over eight headings; no layout")
                .containsPattern("class=\"verdict\">[^<]*Today's sensor covers \\S+ %, averaged over eight headings\\.")
                .containsPattern("class=\"verdict\">[^<]*On the heading that is worst in each cell, the layout covers "
                        + percent(json.get("worst_heading")) + " %")
                .contains(">all heights, averaged over eight headings</th>");
        assertThat(page.split("This table states the coverage averaged over eight headings[.]"))
                .hasSize(3);
        for (JsonNode sensor : json.get("chosen")) {
            assertThat(page)
                    .containsPattern("<td[^>]*>without " + sensor.get("sensor").asString() + "</td><td[^>]*>"
                            + percent(sensor.get("without")) + " %</td>");
        }
    }

    /** The page's example: its table of what each sensor covers, and the sentences below it. */
    @Test
    void thePageStatesTheLayoutAtMonaco() throws IOException {
        assumeTrue(LongForm.IS_ON, "takes some ten seconds");
        String page = Files.readString(Path.of("src", "site", "markdown", "placement.md"));
        Outcome monaco = place(Path.of("scenes", "palace.place.yaml"));

        assertThat(monaco.code()).as(monaco.err()).isZero();
        List<String> shares = Pattern.compile("\\d+\\.\\d %")
                .matcher(monaco.out())
                .results()
                .map(MatchResult::group)
                .toList();
        assertThat(shares).hasSizeGreaterThan(15).allMatch(page::contains);
    }

    /** {@code again} finds the file unchanged, and place.json the same. */
    @Test
    void againRepeatsIt() {
        Outcome again =
                Program.run("again", directory.resolve("provenance.json").toString());

        assertThat(again.code()).as(again.err()).isZero();
        assertThat(again.out()).contains("same       place.json").doesNotContain("changed since");
    }

    @Test
    void namesTheCandidateThatIsWrong() throws IOException {
        Path bad = directory.resolve("wrong.place.yaml");
        Files.writeString(
                bad,
                "scene: site.yaml\nbudget: 1\ncandidates:\n  a: {sensor: {use: spotter}, price: 1, places: [[0, 0, 4]]}\n");

        assertThat(place(bad).err()).contains("wrong.place.yaml:4:").contains("candidates.a.sensor.use: unknown name");
    }
}

package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.PlacedSite;
import org.dronewatch.report.placement.PlaceDirectory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What is said of candidates that can see nothing from where they are, or cannot be bought. */
class PlaceCandidatesTest {
    @TempDir
    private Path directory;

    @Test
    void candidatesInsideABuildingAreNamed() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 4\n");
        // The building is 30 m high.
        String inside = Files.readString(file).replace("places: [[0, 0, 30]]", "places: [[0, 0, 30], [0, 65, 10]]");
        Files.writeString(file, inside);

        Outcome outcome = Program.run("place", file.toString(), "--budgets=1", "--quiet");

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .containsOnlyOnce("inside a wall")
                .containsPattern("warning: candidates 'eye-2-\\d+', 'eye-2-\\d+', 'eye-2-\\d+' and 1 more seem to be"
                        + " inside a wall or under the ground: most surfaces around them face away from them");
    }

    @Test
    void otherCandidatesAreNot() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 4\n");

        assertThat(Program.run("place", file.toString(), "--budgets=1", "--quiet")
                        .err())
                .doesNotContain("inside a wall");
    }

    @Test
    void aBudgetBelowAllPricesIsStated() throws Exception {
        assertThat(placed("budget: 0.5\n"))
                .contains("No sensor is affordable: the cheapest, eye-1-0, costs 1 EUR, and the budget is 0.5 EUR.")
                .doesNotContain("Buying nothing");
    }

    @Test
    void theReportOnAnEmptyLayoutListsNoSensors() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 0.5\n");
        Program.run("place", file.toString(), "--budgets=1", "--quiet", "--out=" + directory);

        assertThat(Files.readString(directory.resolve("report.html")))
                .contains("Nothing is bought, and no sensor is kept.")
                .doesNotContain("Sensors of the layout", "No prices are known", "The sensors are listed");
    }

    /** The receivers of the site receive from all directions. */
    @Test
    void onlySensorsThatHaveADirectionHaveAnAzimuth() throws Exception {
        assertThat(placed("budget: 9\n")).containsPattern("(?m)^radio-\\d +rf +[-\\d., ]+ +- +1\\.5 ");
        assertThat(placed("budget: 1\n")).containsPattern("(?m)^eye-1-\\d+ +camera +[-\\d., ]+ +\\d+° +1 ");
    }

    /** Numbers of sensors that no layout has are refused in one line, before anything is assessed. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "budget: 9\\nconditions: {fold: 10} | conditions.fold 10: must be at most 7, the number of sensors"
                        + " that the budget of 9 allows",
                "budget: 99\\nconditions: {fold: 4, atMost: 3} | conditions.fold 4: must be at most 3, which is"
                        + " conditions.atMost",
                "budget: 99\\nconditions: {atMost: 2}\\nkeep: [round]\\n+ | conditions.atMost 2: must be at least 3,"
                        + " the number of sensors that are kept or that 'atLeast' asks for",
                "budget: 3\\n+ | budget 3: must be at least 4, the price of the sensors that 'atLeast' asks for",
                "budget: 99\\nconditions: {fold: 10}\\n- | conditions.fold 10: must be at most 7, the number of"
                        + " sensors that the candidates allow",
            })
    void impossibleNumbersAreRefused(String lines, String message) throws Exception {
        String more = lines.replace("\\n", "\n");
        Path file = PlacedSite.in(directory, more.replaceAll("[+-]$", "") + "\n");
        String text = Files.readString(file);
        text = more.endsWith("+") ? text.replace("price: 2\n", "price: 2\n    atLeast: 2\n") : text;
        text = more.endsWith("-") ? text.replace("price: 1.5\n", "price: 1.5\n    atMost: 0\n") : text;
        Files.writeString(file, text);
        Outcome outcome = Program.run("place", file.toString(), "--quiet");

        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err().strip()).matches(".*place\\.yaml:\\d+:\\d+: \\Q" + message + "\\E");
        assertThat(outcome.out()).isEmpty();
    }

    /** As many as there are is possible; what comes of it is said in one line. */
    @Test
    void aFoldOfAllCandidatesIsNoMistake() throws Exception {
        assertThat(placed("budget: 99\nconditions: {fold: 10, atMost: 10}\n"))
                .containsOnlyOnce(
                        "Buying nothing would do as well: since conditions.fold requires 10 sensors, no layout"
                                + " within the budget improves on that.");
    }

    private String placed(String more) throws Exception {
        Path file = PlacedSite.in(directory, more);
        Outcome outcome = Program.run("place", file.toString(), "--budgets=1", "--quiet");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome.out();
    }

    /** Two kept sensors of the same name are one mistake in the list, not a clash with another sensor. */
    @Test
    void aSensorThatIsKeptTwiceIsNamed() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 4\nkeep: [round, round]\n");

        assertThat(Program.run("place", file.toString()).err()).contains("keep: 'round' is named twice");
    }

    @Test
    void aPlaceOutsideTheSiteIsNotBlamedOnTheAirAlone() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 4\n");
        String text = Files.readString(file).replaceAll("places: .*", "places: [[50000, 90, 5]]");
        Files.writeString(file, text.replaceAll("line: .*", "places: [[50000, 90, 5]]"));
        Outcome outcome = Program.run("place", file.toString());

        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err())
                .contains("no cell that the drone can enter; the square is centred on 50000, 90 m, the mean position"
                        + " of the candidates: is a place outside the site?");
    }

    /** A single budget has no others between which a better one may lie. */
    @Test
    void aSingleBudgetIsNotTwo() throws Exception {
        Path site = PlacedSite.in(directory, "budget: 4\n");
        Program.run("place", site.toString(), "--budgets=1", "--out=" + directory.resolve("results"));

        assertThat(Files.readString(directory.resolve("results/report.html")))
                .contains("Only this budget was tried: a cheaper layout may be a better buy.");
    }

    @Test
    void aLayoutThatIsWorseThanTodayIsCalledThat() throws Exception {
        assertThat(placed("budget: 1\n"))
                .contains(
                        "better than this layout: sensors of the scene that 'keep' does not name are not part of it.");
        assertThat(placed("budget: 9\n")).doesNotContain("better than this layout");
    }

    /** The first purchases alone meet a condition only by chance. */
    @Test
    void purchasesThatDoNotComplyYetAreCounted() throws Exception {
        String printed = placed("budget: 9\nconditions: {anyoneLost: {atLeast: 0.2}}\n");

        Matcher remains = Pattern.compile("The first( \\d)? purchases? alone do(es)? not meet the conditions"
                        + " \\(after the worst loss, (\\d+\\.\\d) % remains\\)\\.")
                .matcher(printed);

        assertThat(remains.find()).as(printed).isTrue();
        assertThat(Double.parseDouble(remains.group(3))).isLessThan(20.0);
        assertThat(placed("budget: 9\n")).doesNotContain("alone do");
    }

    /** The models of the site are not below the directory of the results: the layout cannot be written there. */
    @Test
    void aLayoutThatIsNotWrittenIsNotOffered() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 4\n");
        Outcome outcome =
                Program.run("place", file.toString(), "--budgets=1", "--quiet", "--out=" + directory.resolve("layout"));

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(directory.resolve("layout/layout.yaml")).doesNotExist();
        assertThat(outcome.err()).contains("warning: the layout is not written as a scene");
        assertThat(outcome.out()).contains("The layout covers").doesNotContain("layout.yaml");
        assertThat(Files.readString(directory.resolve("layout/report.html"))).doesNotContain("layout.yaml");
        assertThat(Program.run("place", file.toString(), "--budgets=1", "--quiet")
                        .out())
                .contains("The layout covers")
                .doesNotContain("layout.yaml");
    }

    @Test
    void aLayoutThatIsWrittenCanBeAssessedAgain() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 4\n");
        Outcome outcome = Program.run("place", file.toString(), "--budgets=1", "--quiet", "--out=" + directory);

        String command = "This command gives the figures of the layout: dronewatch coverage "
                + directory.resolve("layout.yaml") + " --";
        assertThat(outcome.out()).contains(command);
        assertThat(Files.readString(directory.resolve("report.html"))).contains(command);
    }

    /** The directory that is named takes the layout, even if that of the scene has the results of another command. */
    @Thorough
    @Test
    void theDirectoryThatIsAdvisedWillDo() throws Exception {
        Path site = Files.createDirectory(directory.resolve("site"));
        String file = PlacedSite.in(site, "budget: 4\n").toString();
        Path elsewhere = directory.resolve("layout");

        assertThat(advised(file, elsewhere)).isEqualTo(site);
        Files.writeString(site.resolve("route.json"), "{}");
        assertThat(advised(file, elsewhere)).isEqualTo(directory);
        assertThat(Program.run("place", file, "--budgets=1", "--out=" + directory)
                        .complaints())
                .noneMatch(line -> line.startsWith("warning: the layout is not written"));
        assertThat(directory.resolve("layout.yaml")).isNotEmptyFile();
    }

    /** All files that the layout names count, not only those of the site. */
    @Test
    void aDroneThatCannotBeNamedIsForeseen() throws Exception {
        Path world = Files.createDirectory(directory.resolve("world"));
        Path drones = Files.createDirectory(directory.resolve("drones"));
        Path file = Files.move(PlacedSite.in(world, "budget: 4\n"), directory.resolve("radars.place.yaml"));
        Files.copy(world.resolve("building.obj"), drones.resolve("box.obj"));
        String site = Files.readString(world.resolve("site.yaml"));
        Files.writeString(
                directory.resolve("site.yaml"),
                site.replace("{file: ", "{file: world/").replace("packaged:quadrotor.obj", "drones/box.obj"));
        PlacePlan plan = PlacePlan.read(file, runner -> {}, note -> {});
        List<String> notes = new ArrayList<>();
        try (PlaceDirectory out = new PlaceDirectory(world, file, plan)) {
            out.foresee(notes::add);
            out.foresee(notes::add);
        }

        assertThat(notes).hasSize(1);
        assertThat(notes.get(0))
                .startsWith(
                        "warning: the layout is not written as a scene, so there is no layout.yaml: drones.one.model")
                .endsWith("cannot name it; use --out " + directory);
        try (PlaceDirectory out = new PlaceDirectory(directory, file, plan)) {
            out.foresee(notes::add);
        }
        assertThat(notes).hasSize(1);
    }

    /** A search may begin with the layout of an earlier one, which must not replace it. */
    @Test
    void theSceneOfTheSearchIsNotReplaced() throws Exception {
        Path site = Files.createDirectory(directory.resolve("site"));
        Path file = PlacedSite.in(site, "budget: 4\n");
        Path scene = Files.move(site.resolve("site.yaml"), site.resolve("layout.yaml"));
        Files.writeString(file, Files.readString(file).replace("site.yaml", "layout.yaml"));
        Files.writeString(site.resolve("place.json"), "{}");
        String before = Files.readString(scene);
        Outcome refused = Program.run("place", file.toString(), "--budgets=1", "--out=" + site);

        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.complaints())
                .containsExactly("output directory " + site + " holds an input of the command (layout.yaml), which"
                        + " would be replaced: choose another directory");
        assertThat(scene).hasContent(before);
        assertThat(advised(file.toString(), directory.resolve("elsewhere"))).isEqualTo(directory);
    }

    /** The directory that the warning, which is given only once, advises. */
    private static Path advised(String file, Path out) {
        Outcome outcome = Program.run("place", file, "--budgets=1", "--quiet", "--out=" + out);
        List<String> warnings = outcome.err()
                .lines()
                .filter(line -> line.startsWith("warning: the layout is not written as a scene"))
                .toList();
        assertThat(warnings).as(outcome.err()).hasSize(1);
        assertThat(warnings.get(0)).doesNotContain("write the scene into");
        Matcher advice = Pattern.compile("cannot name it; use --out (.*)$").matcher(warnings.get(0));
        assertThat(advice.find()).as(warnings.get(0)).isTrue();
        return Path.of(advice.group(1));
    }

    /** A cheaper layout that prints alike takes the place of the best one only where a gap is allowed. */
    @Thorough
    @Test
    void withoutAGapTheBestLayoutIsChosenHoweverLittleBetter() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 18\n");
        Files.writeString(file, Files.readString(file).replace("cell: 80 m", "cell: 16 m"));
        JsonNode cheaper = json(file, "--gap=1e-9");
        JsonNode best = json(file, "--gap=0");

        assertThat(best.get("value")).isEqualTo(best.get("bound")).isEqualTo(cheaper.get("bound"));
        assertThat(best.get("value").asDouble())
                .isGreaterThan(cheaper.get("value").asDouble())
                .isCloseTo(cheaper.get("value").asDouble(), within(5e-4));
        assertThat(best.get("cost").asDouble())
                .isGreaterThan(cheaper.get("cost").asDouble());
    }

    private static JsonNode json(Path file, String gap) {
        String printed =
                Program.run("place", file.toString(), "--json", "--quiet", gap).out();
        return JsonMapper.builder().build().readTree(printed);
    }

    /** A camera that turns is worth nothing as long as nothing tells it where the drone is. */
    @Test
    void aTurningSensorIsBoughtOnlyWithOneThatCuesIt() throws Exception {
        String alone = turning("budget: 3\n");
        String together = turning("budget: 6\n");

        assertThat(alone).doesNotContain("eye-1-turn ");
        assertThat(alone).doesNotContain("turned to the drone");
        // The fixed camera may cue the other, but sees little.
        assertThat(together)
                .contains("eye-1-turn ")
                .contains("The figures assume that eye-1-turn has turned to the drone, wherever it is; on its own, the"
                        + " sensor that cues it covers 2.1 %.");
    }

    /** Without the only sensor that cues it, a camera that turns detects nothing either; the condition counts that. */
    @Test
    void aLossTakesAlongWhatItCued() throws Exception {
        assertThat(turning("budget: 6\n"))
                .containsPattern(
                        "Without (\\S+), whose loss is worst, the layout covers 0\\.0 %, averaged over eight headings\\. Without \\1, nothing"
                                + " cues eye-1-turn, which then counts as detecting nothing\\.")
                .contains("After a loss, the coverage by height still counts sensors as turned to the drone, even if"
                        + " nothing cues them any longer.");
        Outcome asked = turningOutcome("budget: 6\nconditions: {anyoneLost: {atLeast: 0.01}}\n");
        assertThat(asked.code()).isEqualTo(2);
        assertThat(asked.err())
                .contains("no layout was found that keeps to it and to the limits on the numbers of sensors, and"
                        + " leaves a coverage of 0.01 after the loss of any one sensor");
    }

    @Test
    void aKeptSensorThatNothingCuesIsNamed() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 0\nkeep: [turning]\n");
        FieldSite.in(
                directory,
                FieldSite.ROUND
                        + "  turning: {kind: camera, position: [3, 0, 34], fov: 6 deg, width: 640, height: 480,"
                        + " positioner: {cues: [round]}}\n");
        Outcome outcome = Program.run("place", file.toString(), "--budgets=1", "--quiet");

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out())
                .contains("Nothing in the layout cues turning, though the figures assume that it has turned to the"
                        + " drone; without turning, the layout covers 0.0 %.");
    }

    private String turning(String budget) throws Exception {
        Outcome outcome = turningOutcome(budget);
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome.out();
    }

    private Outcome turningOutcome(String budget) throws Exception {
        Path file = PlacedSite.in(directory, budget);
        Files.writeString(
                file,
                """
                scene: site.yaml
                candidates:
                  radar:
                    sensor: {kind: radar, minRange: 1, maxRange: 60, elevationWidth: 90 deg, minSpeed: 3 m/s,
                      budget: {range: 5000, crossSection: 0.01}}
                    price: 3
                    places: [[0, 0, 4]]
                  eye:
                    sensor: {kind: camera, fov: 6 deg, width: 1600, height: 1200}
                    price: 2
                    places: [[0, 0, 34]]
                    positioners: {turn: {positioner: {use: viper}, price: 1}}
                air: {side: 400 m, cell: 80 m, heights: [10 m, 40 m]}
                """
                        + budget);
        return Program.run("place", file.toString(), "--budgets=1", "--quiet");
    }
}

package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.app.Main;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.Positioners;
import org.dronewatch.examples.Patrol;
import org.dronewatch.geo.Origin;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the pages show works as it stands there. */
class GuideTest {
    private static final Path PAGES = Path.of("src/site/markdown");

    @TempDir
    private Path directory;

    /** The first block of YAML in a page. */
    private static String firstExample(Path page) throws IOException {
        return firstExample(Files.readString(page));
    }

    static String firstExample(String text) {
        Matcher block = Pattern.compile("```yaml\n(.*?)```", Pattern.DOTALL).matcher(text);
        assertThat(block.find()).isTrue();
        return block.group(1);
    }

    @Test
    void theFirstSceneRuns() throws IOException {
        Path file = directory.resolve("gate.yaml");
        Files.writeString(file, firstExample(PAGES.resolve("guide.md")));
        SceneResult result = new SceneRunner(new SceneFile(file)).run();

        assertThat(result.firstDetectionRange(0, "roof", "visitor")).isPresent();
    }

    /** The example has but the line that a scene needs for maps: it is put into the first scene. */
    @Test
    void theOriginInTheGuideIsThatOfAMap() throws IOException {
        Path page = PAGES.resolve("guide.md");
        String maps = Files.readString(page).split("## Maps\n", 2)[1];
        Matcher block =
                Pattern.compile("```yaml\n(world:\n.*?)```", Pattern.DOTALL).matcher(maps);
        assertThat(block.find()).isTrue();
        Path file = directory.resolve("mapped.yaml");
        Files.writeString(file, firstExample(page).replaceFirst("world:\n", block.group(1)));
        Origin origin = new SceneFile(file).describe().world().origin().orElseThrow();

        assertThat(Math.toDegrees(origin.latitude())).isCloseTo(50.08, within(1e-9));
        assertThat(Math.toDegrees(origin.longitude())).isCloseTo(14.42, within(1e-9));
    }

    @Test
    void theSceneOfThreatsRuns() throws IOException {
        String guide = Files.readString(PAGES.resolve("guide.md"));
        Path file = directory.resolve("threats.yaml");
        Files.writeString(file, firstExample(guide.substring(guide.indexOf("## Threats"))));
        SceneRunner runner = new SceneRunner(new SceneFile(file)).set("drones.creeper.swarm", "3");
        SceneResult result = runner.run();

        assertThat(result.pairs()).hasSize(2 * 11);
        assertThat(result.firstDetectionRange("radar", "diver")).isPresent();
        assertThat(result.firstDetectionRange("radar", "decoys-5")).isPresent();
        // It is seen only once it has risen: from behind the brow it does not show before 118 m.
        PairResult seen = result.pairs().stream()
                .filter(pair -> pair.sensor().equals("eye") && pair.drone().equals("watcher"))
                .findFirst()
                .orElseThrow();
        assertThat(seen.firstDetected().orElseThrow()).isBetween(11.0, 20.0);
        assertThat(result.firstDetectionRange("radar", "watcher")).isEmpty();
    }

    /** The program of the guide flies the scene of the guide, and with its other flight the scene repeats that. */
    @Test
    void thePatrolIsFlownRecordedAndReplayed() throws IOException {
        String guide = Files.readString(PAGES.resolve("guide.md"));
        Path scene = directory.resolve("patrol.yaml");
        Files.writeString(
                scene,
                firstExample(guide.substring(guide.indexOf("### Fly the drones of a scene file, and record them"))));
        Path flown = directory.resolve("patrol");
        Path replayed = directory.resolve("replayed");
        Patrol.record(scene, flown);
        assertThat(Files.readString(flown.resolve("flights.csv")).lines())
                .as("the header, four sides of five seconds and what begins with the last look")
                .hasSize(6);

        String steered = lineWith(guide, "flight: {kind: steered, ");
        String recorded = lineWith(guide, "flight: {kind: recorded, file: patrol/");
        Files.writeString(scene, Files.readString(scene).replace(steered, recorded));
        List<String> command = List.of("run", scene.toString(), "--observations", "--out", replayed.toString());
        StringWriter said = new StringWriter();
        PrintWriter writer = new PrintWriter(said);
        assertThat(Main.execute(writer, writer, command.toArray(String[]::new)))
                .as("%s", said)
                .isZero();
        assertThat(Files.readString(replayed.resolve("observations.csv")))
                .contains(",guard,")
                .isEqualTo(Files.readString(flown.resolve("observations.csv")));
    }

    private static String lineWith(String text, String part) {
        return text.lines().filter(line -> line.contains(part)).findFirst().orElseThrow();
    }

    /** Pages whose first example is a whole scene. */
    @ParameterizedTest
    @CsvSource({"positioner, eye", "alert, radar", "thermal, heat"})
    void theSceneOfAPageRuns(String page, String sensor) throws IOException {
        Path file = directory.resolve(page + ".yaml");
        Files.writeString(file, firstExample(PAGES.resolve(page + ".md")));
        SceneResult result = new SceneRunner(new SceneFile(file)).run();

        assertThat(result.firstDetectionRange(sensor, "intruder")).isPresent();
        assertThat(result.alert("intruder").time()).isPresent();
    }

    @Test
    void anEntryOfOnesOwnIsRead() throws IOException {
        Files.writeString(directory.resolve("mine.yaml"), firstExample(PAGES.resolve("catalogue.md")));
        assertThat(Catalog.beside(directory).entry("mine").orElseThrow().kind()).isEqualTo("radar");
    }

    @Test
    void theSceneInTheReadmeIsTheFile() throws IOException {
        String file = Files.readString(Path.of("scenes/hill-radar.yaml"));
        Matcher block =
                Pattern.compile("```yaml\n(.*?)```", Pattern.DOTALL).matcher(Files.readString(Path.of("README.md")));
        assertThat(block.find()).isTrue();
        assertThat(file).endsWith(block.group(1));
    }

    @Test
    void thePageOfTheCatalogueNamesEveryEntry() throws IOException {
        String page = Files.readString(PAGES.resolve("catalogue.md"));
        List<String> missing = Stream.concat(Catalog.packagedNames().stream(), Positioners.packagedNames().stream())
                .filter(name -> !page.contains("`" + name + "`"))
                .collect(Collectors.toList());
        assertThat(missing).isEmpty();
    }
}

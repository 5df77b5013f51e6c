package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.app.Main;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Whatever part of a scene file a page shows can be copied: with the other parts it is a scene. */
class DocScenesTest {
    private static final Pattern BLOCK = Pattern.compile("```yaml\\n(.*?)```", Pattern.DOTALL);
    private static final Pattern SECTION = Pattern.compile("^([a-z][A-Za-z]*):", Pattern.MULTILINE);

    /** What stands in where a page shows only a part. */
    private static final Map<String, String> OTHERS = new LinkedHashMap<>(Map.of(
            "world",
            "world: {models: [packaged:hill.obj]}\n",
            "drones",
            "drones: {intruder: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 100, 160]}}}\n",
            "sensors",
            "sensors: {eye: {kind: camera, position: [0, 0, 150], aim: {lookAt: [0, 100, 160]}}}\n"));

    /** Sweeps are left out: they refer to the rest of a scene. */
    private static final Set<String> OF_A_SCENE =
            Set.of("name", "summary", "world", "drones", "sensors", "alert", "run", "prices");

    private static final String RADAR = "sensors:\n  radar:\n    kind: radar\n    position: [0, 0, 150]\n"
            + "    budget: {kind: data-sheet, range: 500 m, crossSection: 0.05}\n";

    /** Where a part of a scene belongs; each level of these is indented by two. */
    private static final Map<String, String> AROUND = Map.of(
            "surfaces", "world:\n  models: [yard.obj]\n",
            "flight", "drones:\n  intruder:\n    model: packaged:quadrotor.obj\n",
            "propagation", "sensors:\n  ear:\n    kind: acoustic\n    position: [0, 0, 150]\n",
            "beam", RADAR,
            "falseAlarms", "sensors:\n  radio:\n    use: droneshield-rfone\n    position: [0, 0, 150]\n");

    /** What a page sweeps; its sensors may be followed by those of the page. */
    private static final String SWEPT = "drones:\n  visitor:\n    model: packaged:quadrotor.obj\n"
            + "    flight: {kind: inbound, target: [0, 0, 145], bearing: 20 deg, distance: 200 m}\n"
            + "sensors:\n  tower: {use: spotterrf-c550, position: [0, 0, 144]}\n";

    /** A yard with the materials of the guide. */
    private static final String YARD = "v 0 0 0\nv 9 0 0\nv 9 0 -9\nv 0 0 -9\n"
            + "usemtl facade\nf 1 2 3\nusemtl yard\nf 1 3 4\nusemtl lawn\nf 1 2 4\n";

    @TempDir
    private Path directory;

    /** A page's example. */
    record Example(String page, String text) {
        Set<String> sections() {
            Set<String> sections = new TreeSet<>();
            Matcher matcher = SECTION.matcher(text);
            while (matcher.find()) {
                sections.add(matcher.group(1));
            }
            return sections;
        }

        boolean isOfAScene() {
            return !sections().isEmpty() && OF_A_SCENE.containsAll(sections());
        }

        /** The word with which it begins. */
        String begin() {
            return text.strip().split(":", 2)[0];
        }

        @Override
        public String toString() {
            return page + " " + sections();
        }
    }

    static List<Example> examples() throws IOException {
        return all().filter(Example::isOfAScene).toList();
    }

    /** What is less than a section of a scene; the files of tutorials have tests of their own. */
    static List<Example> parts() throws IOException {
        return all().filter(example -> !example.isOfAScene())
                .filter(example -> !example.page().startsWith("tutorial-"))
                .toList();
    }

    private static Stream<Example> all() throws IOException {
        List<Path> pages = new ArrayList<>(List.of(Path.of("README.md")));
        try (Stream<Path> found = Files.walk(Path.of("src/site/markdown"))) {
            found.filter(page -> page.toString().endsWith(".md")).sorted().forEach(pages::add);
        }
        List<Example> examples = new ArrayList<>();
        for (Path page : pages) {
            Matcher matcher = BLOCK.matcher(Files.readString(page));
            while (matcher.find()) {
                examples.add(new Example(
                        page.getFileName().toString(),
                        matcher.group(1).stripTrailing().stripIndent() + "\n"));
            }
        }
        return examples.stream();
    }

    @ParameterizedTest
    @MethodSource("parts")
    void aPartFitsWhereItBelongs(Example part) throws IOException {
        Files.writeString(directory.resolve("yard.obj"), YARD);
        Path file = directory.resolve("part.yaml");
        switch (part.begin()) {
            case "title" -> {
                Files.writeString(file, part.text());
                assertThat(Catalog.beside(directory).entry("part")).isPresent();
            }
            case "full moon" -> {
                Files.writeString(file, part.text());
                assertCovers("scenes/meadow.yaml", "--conditions", file.toString());
            }
            default -> assertReads(new Example(part.page(), whole(part)));
        }
    }

    private static String whole(Example part) {
        if (part.text().contains("sweep:")) {
            return SWEPT + part.text().replaceFirst("^sensors:\n", "");
        }
        String around = AROUND.get(part.begin());
        assertThat(around).as("where it belongs: %s", part.text()).isNotNull();
        return around + part.text().indent(part.begin().equals("surfaces") ? 2 : 4);
    }

    private void assertCovers(String... scene) {
        List<String> words = new ArrayList<>(List.of("coverage"));
        words.addAll(List.of(scene));
        words.addAll(List.of("--side", "200m", "--cell", "100m", "--heights", "30m"));
        words.addAll(List.of("--out", directory.resolve("field").toString()));
        StringWriter said = new StringWriter();
        PrintWriter writer = new PrintWriter(said);
        assertThat(Main.execute(writer, writer, words.toArray(String[]::new)))
                .as("%s", said)
                .isZero();
    }

    @Test
    void mostPagesShowOne() throws IOException {
        assertThat(examples()).hasSizeGreaterThan(12);
        assertThat(examples().stream().map(Example::page).collect(Collectors.toSet()))
                .contains("README.md", "guide.md", "microphone.md", "terrain.md", "positioner.md");
    }

    @ParameterizedTest
    @MethodSource("examples")
    void itIsAScene(Example example) throws IOException {
        assertReads(example);
    }

    private void assertReads(Example example) throws IOException {
        boolean isPlace = example.text().contains("models:") || example.text().contains("terrain:");
        StringBuilder scene = new StringBuilder(
                isPlace
                        ? example.text()
                        : example.text().replaceFirst("(?m)^world:\\n", "world:\n  models: [packaged:hill.obj]\n"));
        OTHERS.forEach((section, text) -> {
            if (!example.sections().contains(section)) {
                scene.append('\n').append(text);
            }
        });
        for (String file : List.of("monaco-srtm.asc", "monaco.osm.gz", "approach.plan", "approach.gpx")) {
            String where = file.startsWith("monaco") ? "sites" : "src/examples/terrain";
            Files.copy(Path.of(where, file), directory.resolve(file));
        }
        Path file = Files.writeString(directory.resolve("scene.yaml"), scene);
        String refusal = "";
        try {
            new SceneRunner(new SceneFile(file)).settings();
        } catch (InputException e) {
            refusal = e.getMessage();
        }
        // Models and their places stand for those of the reader.
        assertThat(refusal).as("%s", scene).matches("(?s)|.*does not exist in .*|.*needs 'model'");
    }
}

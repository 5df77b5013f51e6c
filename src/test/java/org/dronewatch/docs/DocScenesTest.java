package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
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

        @Override
        public String toString() {
            return page + " " + sections();
        }
    }

    static List<Example> examples() throws IOException {
        List<Path> pages = new ArrayList<>(List.of(Path.of("README.md")));
        try (Stream<Path> found = Files.walk(Path.of("src/site/markdown"))) {
            found.filter(page -> page.toString().endsWith(".md")).sorted().forEach(pages::add);
        }
        List<Example> examples = new ArrayList<>();
        for (Path page : pages) {
            Matcher matcher = BLOCK.matcher(Files.readString(page));
            while (matcher.find()) {
                examples.add(new Example(page.getFileName().toString(), matcher.group(1)));
            }
        }
        return examples.stream().filter(Example::isOfAScene).toList();
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

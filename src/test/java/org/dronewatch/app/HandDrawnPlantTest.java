package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The plant of the page on buildings: its files as they are printed there, and its commands in their order. */
class HandDrawnPlantTest {
    private static final Path PAGE = Path.of("src", "site", "markdown", "buildings.md");

    @TempDir
    private Path directory;

    /** The section of the page. */
    private static String section() throws IOException {
        String page = Files.readString(PAGE);
        int begin = page.indexOf("## A plant drawn by hand");
        return page.substring(begin, page.indexOf("\n## ", begin));
    }

    private static String block(String section, String language) {
        Matcher block =
                Pattern.compile("```" + language + "\n(.*?)```", Pattern.DOTALL).matcher(section);
        assertThat(block.find()).as(language).isTrue();
        return block.group(1);
    }

    /**
     * With files and directories of the page in the test's directory. The microphone, whose sound takes most of the
     * time, is switched off in the scene once it has been written, and routes are searched in larger cells.
     */
    private String[] words(String command) {
        String microphone = command.contains(" new ") ? "" : " --set sensors.microphone.enabled=false";
        return Pattern.compile(" ")
                .splitAsStream(command.strip().substring("dronewatch ".length()).replace("--cell 40m", "--cell 80m")
                        + microphone)
                .map(word -> word.startsWith("plant") || word.equals("flat.asc")
                        ? directory.resolve(word).toString()
                        : word)
                .toArray(String[]::new);
    }

    @Thorough
    @Test
    void theCommandsOfThePageRun() throws IOException {
        String section = section();
        Files.writeString(directory.resolve("plant.geojson"), block(section, "json"));
        Files.writeString(directory.resolve("flat.asc"), block(section, "text"));
        List<String> commands = section.lines()
                .filter(line -> line.startsWith("    dronewatch "))
                .toList();
        assertThat(commands).hasSize(3);
        for (String command : commands) {
            Outcome outcome = Program.run(words(command));
            assertThat(outcome.code()).as("%s: %s", command, outcome.err()).isZero();
        }

        Path plant = directory.resolve("plant");
        String hidden = "hidden by plant.geojson ('cooling tower'; brick_rendered)";
        assertThat(section).contains(hidden);
        assertThat(plant.resolve("results").resolve("report.html")).content().contains(hidden);
        assertThat(plant.resolve("route-north.yaml")).exists();
    }
}

package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dronewatch.app.Main;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.core.util.DefaultIndenter;
import tools.jackson.core.util.DefaultPrettyPrinter;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * The notebook reads what its commands write, and shows what its cells print. Ten seconds' work: run only with
 * {@code -Ddronewatch.docs=all}; {@code =write} writes what is shown.
 */
@EnabledIfSystemProperty(named = "dronewatch.docs", matches = "all|write")
class NotebookTest {
    private static final Path NOTEBOOK = Path.of("notebooks", "results.ipynb");
    private static final String PYTHON = "python3";
    private static final String END = "=== end of a cell ===";
    /** Each value on a line, so that a change shows what is changed. */
    private static final DefaultIndenter LINES = new DefaultIndenter(" ", "\n");

    private static final JsonMapper MAPPER = JsonMapper.builder().build();

    @TempDir
    private Path directory;

    private final ObjectNode notebook = (ObjectNode) MAPPER.readTree(Files.readString(NOTEBOOK));

    NotebookTest() throws IOException {}

    private static String source(JsonNode cell) {
        StringBuilder source = new StringBuilder();
        cell.get("source").forEach(line -> source.append(line.asString()));
        return source.toString();
    }

    private List<ObjectNode> cells(String type) {
        List<ObjectNode> cells = new ArrayList<>();
        for (JsonNode cell : notebook.get("cells")) {
            if (cell.get("cell_type").asString().equals(type)) {
                cells.add((ObjectNode) cell);
            }
        }
        return cells;
    }

    /** As a reader types the commands, but into the test's directory, and from one thread as from many. */
    private void runCommands() {
        List<String> commands = source(cells("markdown").get(0))
                .lines()
                .filter(line -> line.startsWith("    dronewatch "))
                .map(line -> line.strip().substring("dronewatch ".length()))
                .toList();
        assertThat(commands).hasSize(3);
        for (String command : commands) {
            String[] words =
                    command.replaceFirst("--out ", "--out " + directory + "/").split(" ");
            StringWriter said = new StringWriter();
            PrintWriter writer = new PrintWriter(said);
            assertThat(Main.execute(writer, writer, words))
                    .as("%s: %s", command, said)
                    .isZero();
        }
    }

    private List<String> printed() throws IOException, InterruptedException {
        StringBuilder script = new StringBuilder();
        cells("code").forEach(cell -> script.append(source(cell))
                .append("\nprint('")
                .append(END)
                .append("')\n"));
        Path file = Files.writeString(directory.resolve("cells.py"), script);
        Path out = directory.resolve("printed");
        Process python = new ProcessBuilder(PYTHON, file.toString())
                .directory(directory.toFile())
                .redirectErrorStream(true)
                .redirectOutput(out.toFile())
                .start();
        assertThat(python.waitFor(60, TimeUnit.SECONDS)).isTrue();
        String all = Files.readString(out, StandardCharsets.UTF_8).replace("\r\n", "\n");
        assertThat(python.exitValue()).as(all).isZero();
        return List.of(all.split(END + "\n"));
    }

    private static boolean hasPython() {
        try {
            return new ProcessBuilder(PYTHON, "--version")
                            .redirectErrorStream(true)
                            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                            .start()
                            .waitFor()
                    == 0;
        } catch (IOException e) {
            return false;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    private static void putOutput(ObjectNode cell, String text) {
        ArrayNode outputs = cell.putArray("outputs");
        if (!text.isEmpty()) {
            ObjectNode output = outputs.addObject();
            output.put("name", "stdout");
            output.put("output_type", "stream");
            ArrayNode lines = output.putArray("text");
            text.lines().forEach(line -> lines.add(line + "\n"));
        }
    }

    @Test
    void theCellsPrintWhatIsShown() throws IOException, InterruptedException {
        assumeTrue(hasPython());
        runCommands();
        List<ObjectNode> cells = cells("code");
        List<String> printed = printed();
        assertThat(printed).hasSameSizeAs(cells);
        JsonNode stored = notebook.deepCopy();
        for (int i = 0; i < cells.size(); i++) {
            putOutput(cells.get(i), printed.get(i));
        }
        if ("write".equals(System.getProperty("dronewatch.docs"))) {
            Files.writeString(
                    NOTEBOOK,
                    MAPPER.writer()
                                    .with(new DefaultPrettyPrinter()
                                            .withArrayIndenter(LINES)
                                            .withObjectIndenter(LINES))
                                    .writeValueAsString(notebook)
                            + "\n");
        } else {
            assertThat(stored).isEqualTo(notebook);
        }
    }
}

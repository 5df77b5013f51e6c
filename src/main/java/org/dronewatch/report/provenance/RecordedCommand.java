package org.dronewatch.report.provenance;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.BoundedFile;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * The command that a {@code provenance.json} states, and the inputs and the environment of its run. Anybody may have
 * written the file, so it is not trusted.
 *
 * @param words the arguments of the command line
 * @param content the whole file
 */
public record RecordedCommand(List<String> words, JsonNode content) {
    private static final int LARGEST = 16 << 20;
    private static final int MOST_WORDS = 10_000;

    /** The keys that may differ between two runs and explain why their results are not the same. */
    private static final List<String> GROUNDS = List.of(
            "version", "java_version", "java_vendor", "architecture", "scene", "models", "campaign", "variants");

    /** Copies the list. */
    public RecordedCommand {
        words = List.copyOf(words);
    }

    /**
     * Reads a file.
     *
     * @throws InputException with a one-line message when it is not such a file, or states no command
     */
    public static RecordedCommand read(Path file) {
        JsonNode root;
        try {
            root = JsonMapper.builder()
                    .build()
                    .readTree(new String(BoundedFile.read(file, LARGEST), StandardCharsets.UTF_8));
        } catch (JacksonException e) {
            throw new InputException(PlainText.value(file) + ": is not JSON", e);
        }
        if (!ProgramVersion.PROGRAM.equals(root.path("program").asString(""))) {
            throw new InputException(
                    PlainText.value(file) + ": is not a provenance.json written by " + ProgramVersion.PROGRAM);
        }
        JsonNode command = root.path("command");
        if (!command.isArray() || command.isEmpty() || command.size() > MOST_WORDS) {
            throw new InputException(PlainText.value(file)
                    + ": records no command; a run that another program started must be repeated" + " by that program");
        }
        List<String> words = new ArrayList<>();
        command.forEach(word -> words.add(word.asString("")));
        return new RecordedCommand(words, root);
    }

    /** Those keys that may explain different results and whose values differ in another provenance. */
    public List<String> differences(RecordedCommand other) {
        return GROUNDS.stream()
                .filter(key -> !content.path(key).equals(other.content.path(key)))
                .toList();
    }
}

package org.dronewatch.report.provenance;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.InputFiles;
import org.dronewatch.setting.input.FileHash;

/**
 * The provenance of results. It differs from run to run, unlike the results.
 *
 * @param date when the run was started, to the second
 * @param command the arguments of the command line; none if the scene was run from Java code
 * @param inputs the settings, scene files and models
 */
public record Provenance(Instant date, List<String> command, InputFiles inputs) {
    /** Copies the list: later changes by the caller have no effect. */
    public Provenance {
        date = date.truncatedTo(ChronoUnit.SECONDS);
        command = List.copyOf(command);
    }

    /** The version of this program. */
    public String version() {
        return ProgramVersion.text();
    }

    /** Version and vendor of the Java virtual machine. */
    public static String java() {
        return System.getProperty("java.version") + " (" + System.getProperty("java.vendor") + ")";
    }

    /** Name and version of the operating system. */
    public static String operatingSystem() {
        return System.getProperty("os.name") + " " + System.getProperty("os.version");
    }

    /** The processor's architecture. */
    public static String architecture() {
        return System.getProperty("os.arch");
    }

    /** All entries in readable form, by label. */
    public Map<String, String> inWords(SceneResult result) {
        return inWords(result.seed(), result.threads());
    }

    /**
     * All entries for results without a run, in readable form, by label.
     *
     * @param seed seed of the scene
     * @param threads number of worker threads
     */
    public Map<String, String> inWords(long seed, int threads) {
        Map<String, String> words = new LinkedHashMap<>();
        words.put("program", ProgramVersion.PROGRAM + " " + version());
        words.put("date", date.toString());
        if (!command.isEmpty()) {
            words.put("command", command.stream().map(Provenance::quoted).collect(Collectors.joining(" ")));
        }
        words.put("seed", Long.toString(seed));
        words.put("threads", Integer.toString(threads));
        words.put("Java", java());
        words.put("system", operatingSystem() + ", " + architecture());
        words.put("SHA-256 of the effective settings", inputs.settingsHash());
        inputs.scene().forEach(file -> words.put("SHA-256 of " + file.file(), file.sha256()));
        allModelFiles().forEach(file -> words.put("SHA-256 of " + file.file(), file.sha256()));
        return words;
    }

    private List<FileHash> allModelFiles() {
        List<FileHash> all = new ArrayList<>();
        inputs.models().values().forEach(all::addAll);
        return all;
    }

    private static String quoted(String argument) {
        return argument.matches("[\\w./:=,+%@-]+") ? argument : "'" + argument.replace("'", "'\\''") + "'";
    }
}

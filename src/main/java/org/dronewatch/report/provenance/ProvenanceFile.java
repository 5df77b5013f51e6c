package org.dronewatch.report.provenance;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Map;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Timing;
import org.dronewatch.scenario.InputFiles;
import org.dronewatch.setting.input.FileHash;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The contents of {@code provenance.json}. */
public final class ProvenanceFile {
    private ProvenanceFile() {}

    /** The name of the file. */
    public static final String NAME = "provenance.json";

    /** The contents for a run; {@code command} is included only if there was a command. */
    public static ObjectNode of(Provenance provenance, SceneResult result) {
        ObjectNode root = program(provenance.date(), provenance.command(), result.threads());
        addTimes(root, result.timing());
        ObjectNode scene = root.putObject("scene");
        scene.put("name", result.scene());
        addInputs(root, scene, provenance.inputs());
        return root;
    }

    /**
     * The contents for results without a run.
     *
     * @param scene name of the scene
     * @param threads number of worker threads
     */
    public static ObjectNode of(Provenance provenance, String scene, int threads) {
        ObjectNode root = program(provenance.date(), provenance.command(), threads);
        ObjectNode node = root.putObject("scene");
        node.put("name", scene);
        addInputs(root, node, provenance.inputs());
        return root;
    }

    /**
     * The contents for a campaign.
     *
     * @param command the arguments of the command line
     * @param files the campaign file, and the table of its cases if it has one
     * @param variants the files from which each variant was read, by the name of the variant
     */
    public static ObjectNode of(
            Instant date, List<String> command, int threads, List<FileHash> files, Map<String, InputFiles> variants) {
        ObjectNode root = program(date.truncatedTo(ChronoUnit.SECONDS), command, threads);
        addFiles(root.putObject("campaign").putArray("files"), files);
        ObjectNode all = root.putObject("variants");
        variants.forEach((name, inputs) -> {
            ObjectNode variant = all.putObject(name);
            addInputs(variant, variant.putObject("scene"), inputs);
        });
        return root;
    }

    private static ObjectNode program(Instant date, List<String> command, int threads) {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("program", ProgramVersion.PROGRAM);
        root.put("version", ProgramVersion.text());
        root.put("date", date.toString());
        if (!command.isEmpty()) {
            ArrayNode words = root.putArray("command");
            command.forEach(words::add);
        }
        root.put("java_version", System.getProperty("java.version"));
        root.put("java_vendor", System.getProperty("java.vendor"));
        root.put("operating_system", Provenance.operatingSystem());
        root.put("architecture", Provenance.architecture());
        root.put("threads", threads);
        return root;
    }

    private static void addInputs(ObjectNode target, ObjectNode scene, InputFiles inputs) {
        scene.put("settings_sha256", inputs.settingsHash());
        addFiles(scene.putArray("files"), inputs.scene());
        ArrayNode models = target.putArray("models");
        inputs.models().forEach((name, files) -> addModel(models.addObject(), name, files));
    }

    private static void addTimes(ObjectNode root, Timing timing) {
        root.put("load_s", rounded(timing.load()));
        root.put("build_s", rounded(timing.build()));
        root.put("wall_s", rounded(timing.wall()));
        ObjectNode looking = root.putObject("looking_s");
        for (Map.Entry<String, Double> kind : timing.looking().entrySet()) {
            looking.put(kind.getKey() + "_s", rounded(kind.getValue()));
        }
    }

    /** A time, rounded to the microsecond. */
    private static double rounded(double seconds) {
        return Math.rint(1e6 * seconds) / 1e6;
    }

    private static void addModel(ObjectNode model, String name, List<FileHash> files) {
        model.put("file", name);
        model.put("sha256", files.get(0).sha256());
        addFiles(model.putArray("materials"), files.subList(1, files.size()));
    }

    private static void addFiles(ArrayNode target, List<FileHash> files) {
        for (FileHash file : files) {
            target.addObject().put("file", file.file()).put("sha256", file.sha256());
        }
    }
}

package org.dronewatch.report.provenance;

import java.util.List;
import java.util.Map;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Timing;
import org.dronewatch.setting.file.FileHash;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The contents of {@code provenance.json}. */
public final class ProvenanceFile {
    private ProvenanceFile() {}

    /** All keys; {@code command} only if there was a command. */
    public static ObjectNode of(Provenance provenance, SceneResult result) {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("program", ProgramVersion.PROGRAM);
        root.put("version", provenance.version());
        root.put("date", provenance.date().toString());
        if (!provenance.command().isEmpty()) {
            ArrayNode command = root.putArray("command");
            provenance.command().forEach(command::add);
        }
        root.put("java_version", System.getProperty("java.version"));
        root.put("java_vendor", System.getProperty("java.vendor"));
        root.put("operating_system", Provenance.operatingSystem());
        root.put("architecture", Provenance.architecture());
        root.put("threads", result.threads());
        addTimes(root, result.timing());
        ObjectNode scene = root.putObject("scene");
        scene.put("name", result.scene());
        scene.put("settings_sha256", provenance.inputs().settingsHash());
        addFiles(scene.putArray("files"), provenance.inputs().scene());
        ArrayNode models = root.putArray("models");
        provenance.inputs().models().forEach((name, files) -> addModel(models.addObject(), name, files));
        return root;
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

    /** To the microsecond. */
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

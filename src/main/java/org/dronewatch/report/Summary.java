package org.dronewatch.report;

import org.dronewatch.report.file.Numbers;
import org.dronewatch.run.SceneResult;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The contents of {@code summary.json}: the result, and how long it took. */
final class Summary {
    private final SceneResult result;

    Summary(SceneResult result) {
        this.result = result;
    }

    /** All keys. */
    ObjectNode toJson() {
        double wall = result.timing().wall();
        ResultFile findings = new ResultFile(result);
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("scene", result.scene());
        root.put("seed", result.seed());
        root.put("threads", result.threads());
        findings.addOrigin(root);
        root.put("simulated_s", Numbers.rounded(result.simulated()));
        root.put("load_s", Numbers.rounded(result.timing().load()));
        root.put("build_s", Numbers.rounded(result.timing().build()));
        root.put("wall_s", Numbers.rounded(wall));
        ObjectNode looking = root.putObject("looking_s");
        result.timing().looking().forEach((kind, seconds) -> looking.put(kind + "_s", Numbers.rounded(seconds)));
        root.put("real_time_factor", Numbers.rounded(result.simulated() / wall));
        findings.addFindings(root);
        return root;
    }
}

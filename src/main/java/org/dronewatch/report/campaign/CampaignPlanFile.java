package org.dronewatch.report.campaign;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.report.provenance.ProgramVersion;
import org.dronewatch.report.provenance.ResultKind;
import org.dronewatch.setting.CanonicalSettings;
import org.dronewatch.setting.input.FileHash;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The contents of {@code plan.json}: what is run, with the hash of all that it depends on. */
final class CampaignPlanFile {
    /** The name of the file. */
    static final String NAME = ResultKind.CAMPAIGN.sign();

    private static final int FORMAT = 1;
    private static final String HASH = "hash";
    private static final long LONGEST = 1 << 20;

    private final CampaignPlan plan;

    CampaignPlanFile(CampaignPlan plan) {
        this.plan = plan;
    }

    ObjectNode toJson() {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("format", FORMAT);
        root.put("scene", plan.settings().scene());
        root.put("seed", plan.settings().seed());
        root.put("runs", plan.size());
        ArrayNode variants = root.putArray("variants");
        plan.variants().forEach(variants::add);
        ArrayNode paths = root.putArray("vary");
        plan.paths().forEach(paths::add);
        root.put("version", ProgramVersion.text());
        root.put(HASH, hash());
        return root;
    }

    /** SHA-256 of the campaign, of the settings of all variants, of their model files, and of the program's version. */
    String hash() {
        StringBuilder all = new StringBuilder(ProgramVersion.text()).append('\n');
        all.append(CanonicalSettings.of(plan.settings()));
        plan.tableHash().ifPresent(hash -> all.append(hash).append('\n'));
        plan.variedHashes().forEach(hash -> all.append(hash).append('\n'));
        for (String variant : plan.variants()) {
            all.append(variant).append('\n').append(CanonicalSettings.of(plan.shared(variant)));
            plan.files(variant)
                    .forEach((name, files) -> files.forEach(file ->
                            all.append(name).append(' ').append(file.sha256()).append('\n')));
        }
        return FileHash.ofText(all.toString());
    }

    /** Whether a file holds the plan of the same campaign. */
    boolean isSameAs(Path file) throws IOException {
        if (Files.size(file) > LONGEST) {
            return false;
        }
        try {
            JsonNode there = JsonMapper.builder().build().readTree(Files.readString(file, StandardCharsets.UTF_8));
            return hash().equals(there.path(HASH).asString(""));
        } catch (JacksonException e) {
            return false;
        }
    }
}

package org.dronewatch.app;

import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.report.provenance.ProvenanceFile;
import org.dronewatch.scenario.InputFiles;
import org.dronewatch.setting.input.FileHash;
import tools.jackson.databind.node.ObjectNode;

/** The origin of a campaign's results. */
final class CampaignOrigin {
    private CampaignOrigin() {}

    /**
     * The contents of {@code provenance.json}.
     *
     * @param file campaign file, if there is one
     * @param command the arguments of the command line that produces the results
     */
    static ObjectNode of(CampaignPlan plan, Optional<Path> file, List<String> command, int threads) {
        List<FileHash> files = new ArrayList<>();
        file.ifPresent(given -> {
            files.add(InputFiles.hash(given));
            Path directory = given.toAbsolutePath().normalize().getParent();
            plan.settings().table().ifPresent(name -> files.add(InputFiles.hash(directory.resolve(name))));
        });
        Map<String, InputFiles> variants = new LinkedHashMap<>();
        plan.variants().forEach(name -> variants.put(name, plan.inputs(name)));
        return ProvenanceFile.of(Instant.now(), command, threads, files, variants);
    }
}

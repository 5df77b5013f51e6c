package org.dronewatch.spark;

import java.io.Serializable;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.CampaignSettings;
import org.dronewatch.report.campaign.RemoteChunks;
import org.dronewatch.setting.SettingsPath;

/**
 * What an executor needs to know to run the chunks of a campaign.
 *
 * @param hash of the campaign as the driver has read it
 * @param file the campaign file: as executors see it if it is shared, otherwise its name in the archive
 * @param isShared whether executors read it, and what it needs, where it is
 * @param directory that of the campaign file on the driver, which the messages of failed cases name
 * @param variants the changes of each variant, with those of the command line
 * @param seed that of the campaign, which the command line may state
 * @param runs number of cases, which the command line may state; 0 if it is not stated at all
 * @param isStored whether executors may keep prepared sites, each where its own process does
 * @param isSensitivity whether the chunks are those of the cases that show which settings matter
 */
record ChunkOrder(
        String hash,
        String file,
        boolean isShared,
        String directory,
        LinkedHashMap<String, LinkedHashMap<String, String>> variants,
        long seed,
        int runs,
        boolean isStored,
        boolean isSensitivity)
        implements Serializable {
    private static final long serialVersionUID = 1L;

    /** The settings of the campaign as the driver runs it: those of the file, with what the command line states. */
    CampaignSettings applyTo(CampaignSettings settings) {
        Map<String, Map<String, String>> all = new LinkedHashMap<>(variants);
        CampaignSettings own = new SettingsPath("seed").write(settings.withVariants(all), Long.toString(seed));
        return runs == 0 ? own : new SettingsPath("runs").write(own, Integer.toString(runs));
    }

    /**
     * The order to run a campaign.
     *
     * @param file the campaign file on the driver
     * @param shared the same as executors see it; empty if it reaches them in an archive
     */
    static ChunkOrder of(CampaignRun run, Path file, String shared) {
        CampaignPlan plan = run.plan();
        Path known = file.toAbsolutePath().normalize();
        LinkedHashMap<String, LinkedHashMap<String, String>> variants = new LinkedHashMap<>();
        plan.settings().variants().forEach((name, changes) -> variants.put(name, new LinkedHashMap<>(changes)));
        return new ChunkOrder(
                new RemoteChunks(plan).hash(),
                shared.isEmpty() ? String.valueOf(known.getFileName()) : shared,
                !shared.isEmpty(),
                String.valueOf(Objects.requireNonNull(known.getParent())),
                variants,
                plan.settings().seed(),
                plan.settings().runs().orElse(0),
                plan.store().directory().isPresent(),
                run.cases() != plan);
    }
}

package org.dronewatch.report.campaign;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** The results of a part of a campaign, in a directory that is read but never written to. */
public final class CampaignPart {
    private final CampaignPlan plan;
    private final Path directory;

    /**
     * A part of a campaign.
     *
     * @param plan plan of the whole campaign
     * @param directory directory that holds the results of the part
     * @throws InputException with a one-line message when the directory does not hold this campaign
     */
    public CampaignPart(CampaignPlan plan, Path directory) {
        this.plan = plan;
        this.directory = directory;
        Path known = directory.resolve(CampaignPlanFile.NAME);
        try {
            if (!Files.isRegularFile(known)) {
                throw new InputException(PlainText.value(directory) + ": holds no campaign");
            }
            if (!new CampaignPlanFile(plan).isSameAs(known)) {
                throw new InputException(PlainText.value(directory) + ": holds another campaign");
            }
        } catch (IOException e) {
            throw new InputException(PlainText.value(known) + ": cannot be read: " + e.getMessage(), e);
        }
    }

    /**
     * The results of a chunk; empty if the directory does not hold them.
     *
     * @param cases the cases of the campaign, or those that show which settings matter
     * @param chunk index of the chunk, from 0
     */
    public Optional<List<CaseResult>> find(Cases cases, int chunk) {
        Path chunks = directory.resolve(cases == plan ? CampaignFiles.CHUNKS : CampaignFiles.SENSITIVITY);
        return new CaseChunks(cases, chunks, new CaseTable(plan.paths())).find(chunk);
    }
}

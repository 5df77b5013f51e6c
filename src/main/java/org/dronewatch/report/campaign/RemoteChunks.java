package org.dronewatch.report.campaign;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Cases;

/** What two processes that run the same campaign exchange: which campaign it is, and the results of chunks as bytes. */
public final class RemoteChunks {
    private final CampaignPlan plan;
    private final CaseTable table;

    /** The chunks of a campaign, as one of the processes has read it. */
    public RemoteChunks(CampaignPlan plan) {
        this.plan = plan;
        this.table = new CaseTable(plan.paths());
    }

    /**
     * SHA-256 of the campaign, the settings of all variants, their model files and the program's version: processes
     * with the same hash run the same campaign.
     */
    public String hash() {
        return new CampaignPlanFile(plan).hash();
    }

    /** The bytes of the file in which a campaign's directory keeps a chunk. */
    public byte[] write(List<CaseResult> results) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            table.write(bytes, results);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    /**
     * Reads the bytes of a chunk.
     *
     * @param cases the cases of the campaign, or those that show which settings matter
     * @param chunk index of the chunk, from 0
     * @return the results, ordered by case, then by variant
     * @throws IllegalStateException when the bytes are not those of this chunk
     */
    public List<CaseResult> read(Cases cases, int chunk, byte[] bytes) {
        try {
            List<CaseResult> results = table.read(new ByteArrayInputStream(bytes));
            if (CaseChunks.isWhole(cases, chunk, results)) {
                return results;
            }
        } catch (IOException e) {
            throw new IllegalStateException("chunk " + chunk + ": " + e.getMessage(), e);
        }
        throw new IllegalStateException("chunk " + chunk + ": the results are those of other cases");
    }
}

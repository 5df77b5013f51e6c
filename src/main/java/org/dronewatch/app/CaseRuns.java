package org.dronewatch.app;

import java.io.PrintWriter;
import java.util.concurrent.CancellationException;
import org.dronewatch.campaign.CampaignRun;

/**
 * Runs cases and shows their progress until all are done or the user wants to stop.
 *
 * @param interruption knows what the user wants
 * @param err receives the progress
 */
record CaseRuns(Interruption interruption, PrintWriter err) {
    /**
     * Runs the cases that are missing.
     *
     * @param name for the progress
     * @return whether all were run: if not, whole chunks are kept
     */
    boolean run(CampaignRun run, CampaignRun.Chunks kept, String name) {
        try (CaseProgress progress = new CaseProgress(name, run.size(), err)) {
            run.run(kept, progress);
            return true;
        } catch (CancellationException e) {
            if (!interruption.happened()) {
                throw e;
            }
            return false;
        }
    }
}

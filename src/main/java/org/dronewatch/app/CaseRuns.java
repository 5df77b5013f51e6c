package org.dronewatch.app;

import java.util.concurrent.CancellationException;
import org.dronewatch.app.console.CaseProgress;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.CaseExecution;

/**
 * Runs cases and shows their progress until all are done or the user wants to stop.
 *
 * @param interruption reports whether the user wants to stop
 * @param shown shows their progress
 * @param execution runs them, on this machine or elsewhere
 */
record CaseRuns(Interruption interruption, TaskProgress shown, CaseExecution execution) {
    /**
     * Runs the cases that are missing.
     *
     * @param name name of the cases in the display of progress
     * @return whether all were run; if not, the chunks that are complete are kept
     */
    boolean run(CampaignRun run, CampaignRun.Chunks kept, String name) {
        try (CaseProgress progress = shown.cases(name, run.size())) {
            execution.run(run, kept, progress);
            return true;
        } catch (CancellationException e) {
            if (!interruption.happened()) {
                throw e;
            }
            return false;
        }
    }
}

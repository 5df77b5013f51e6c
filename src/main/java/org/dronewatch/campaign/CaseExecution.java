package org.dronewatch.campaign;

/** Where the cases of a campaign are run: in this process, or on other machines. The results are the same. */
@FunctionalInterface
public interface CaseExecution {
    /** In this process. */
    CaseExecution HERE = CampaignRun::run;

    /**
     * Runs the cases whose results have not been kept.
     *
     * @param run what is to be run
     * @param kept where chunks are kept; it is used by one thread at a time, and not after this method returns
     * @throws java.util.concurrent.CancellationException when the thread is interrupted: complete chunks are kept
     */
    void run(CampaignRun run, CampaignRun.Chunks kept, CampaignRun.Progress progress);
}

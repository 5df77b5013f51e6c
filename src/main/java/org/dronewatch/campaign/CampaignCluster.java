package org.dronewatch.campaign;

import java.nio.file.Path;

/** Machines that run the cases of campaigns. */
@FunctionalInterface
public interface CampaignCluster extends AutoCloseable {
    /** No other machines: cases are run in this process. */
    CampaignCluster NONE = file -> CaseExecution.HERE;

    /**
     * What runs the cases of a campaign.
     *
     * @param file the campaign file
     */
    CaseExecution forCampaign(Path file);

    /** Ends what was started for campaigns. */
    @Override
    default void close() {}
}

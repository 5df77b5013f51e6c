package org.dronewatch.spark;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.app.Main;

/**
 * The command {@code campaign}, with its cases run on a Spark cluster: to be started by {@code spark-submit}. Its
 * arguments and its files are those of {@code campaign}.
 */
public final class CampaignOnSpark {
    private CampaignOnSpark() {}

    /**
     * Runs a campaign, and ends the process with its exit code unless that is 0.
     *
     * @param arguments those of {@code campaign}
     */
    public static void main(String[] arguments) {
        List<String> words = new ArrayList<>(List.of("campaign"));
        words.addAll(List.of(arguments));
        Main.main(new SparkCluster(), words.toArray(String[]::new));
    }
}

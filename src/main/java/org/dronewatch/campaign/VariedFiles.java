package org.dronewatch.campaign;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.CanonicalSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.FileHash;

/**
 * The files named by values that vary, so that results computed from other contents are recognised. For use by one
 * thread.
 */
final class VariedFiles {
    /** The name of a file has a suffix; in a quantity, no letter follows the point. */
    private static final Pattern NAME = Pattern.compile("\\.\\p{Alpha}");

    private static final String UNREADABLE = "unreadable";

    private final List<String> hashes = new ArrayList<>();

    /**
     * Reads the files of a variant with a value, if the value may name one. One that cannot be read is not an error
     * yet: the values of other settings may be needed as well, and a case that does need it fails.
     *
     * @param settings settings of the variant, with the value
     */
    void read(CampaignVariant variant, SceneSettings settings, String value) {
        if (!NAME.matcher(value).find()) {
            return;
        }
        // What a catalogue or another file of settings holds is in the settings themselves by now.
        hashes.add(FileHash.ofText(CanonicalSettings.of(settings)));
        try {
            variant.runner().load(settings);
        } catch (InputException e) {
            hashes.add(UNREADABLE);
        }
    }

    /**
     * SHA-256 hashes of the files that were read besides models, in the order of reading: by value, then by variant.
     */
    List<String> hashes() {
        return List.copyOf(hashes);
    }
}

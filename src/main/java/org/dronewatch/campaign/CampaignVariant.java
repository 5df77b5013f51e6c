package org.dronewatch.campaign;

import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;

/**
 * A variant of a campaign, ready to be run: its scene with its own settings and models.
 *
 * @param name its name
 * @param scene name of its scene
 * @param described that scene, without the variant's own settings
 * @param settings those that all cases share
 * @param runner runner of the scene
 * @param models loaded models of the scene; for all threads
 */
record CampaignVariant(
        String name, String scene, Scene described, SceneSettings settings, SceneRunner runner, ModelCache models) {
    /**
     * Reads a variant's scene and loads its models.
     *
     * @param scenes returns the scene with a name
     * @param scene name of the campaign's scene
     * @param changes the variant's settings by their paths
     * @param first the first variant, unless this is the first: if both have the same scene, they share its models
     * @param notes receives a line for each file read, and each warning
     * @throws InputException when the scene, a setting or a model is invalid
     */
    static CampaignVariant of(
            String name,
            CampaignScenes scenes,
            String scene,
            Map<String, String> changes,
            Optional<CampaignVariant> first,
            Consumer<String> notes) {
        String named = changes.getOrDefault(CampaignSettings.SCENE, scene);
        Scene described = scenes.byName().apply(named);
        SceneRunner runner = scenes.runner(described).notes(notes);
        first.filter(other -> other.scene().equals(named)).ifPresent(other -> runner.share(other.models()));
        changes.forEach((path, value) -> {
            if (!path.equals(CampaignSettings.SCENE)) {
                runner.set(path, value);
            }
        });
        SceneSettings settings = runner.settings().withoutSweep();
        runner.checkPilot(settings);
        return new CampaignVariant(name, named, described, settings, runner, runner.load(settings));
    }

    /** The settings with another value, as a sweep writes it. */
    SceneSettings with(SceneSettings before, String path, String value) {
        return runner.write(before, path, value);
    }
}

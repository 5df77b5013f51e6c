package org.dronewatch.campaign;

import java.nio.file.Path;
import java.util.function.Function;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.SceneByName;

/**
 * Where a campaign finds its scenes.
 *
 * @param byName supplies the scene with a given name
 * @param store where the prepared sites of the scenes are kept
 */
public record CampaignScenes(Function<String, Scene> byName, StorePlace store) {
    /**
     * Packaged scenes and scene files, named in a campaign file; prepared sites are kept in the {@link
     * StorePlace#ofProcess store of this process}. A class cannot be named, since no code is loaded from data.
     *
     * @param directory directory of the campaign file
     */
    public static CampaignScenes beside(Path directory) {
        return of(name -> SceneByName.of(directory, name, "campaign file"));
    }

    /**
     * Scenes supplied by the caller; prepared sites are kept in the {@link StorePlace#ofProcess store of this process}.
     */
    public static CampaignScenes of(Function<String, Scene> byName) {
        return new CampaignScenes(byName, StorePlace.ofProcess());
    }

    /** These scenes, with their prepared sites kept elsewhere. */
    public CampaignScenes withStore(StorePlace other) {
        return new CampaignScenes(byName, other);
    }

    /** A runner of a scene. */
    SceneRunner runner(Scene scene) {
        return new SceneRunner(scene).store(store);
    }
}

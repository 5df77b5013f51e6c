package org.dronewatch.campaign;

import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;

/**
 * One case of a campaign with one variant as a scene, to be watched: a run of it gives the results of the case.
 *
 * @param scene the scene, named after the campaign's scene, the case and, if there are several, the variant
 * @param runner runner of the scene, with the models of the campaign, so that nothing is loaded again
 */
public record CaseScene(Scene scene, SceneRunner runner) {}

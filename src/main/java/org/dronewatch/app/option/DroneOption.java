package org.dronewatch.app.option;

import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Option;

/** The option {@code --drone}, for commands that move one drone of the scene to many positions. */
public final class DroneOption {
    @Option(names = "--drone", paramLabel = "ID", description = "Drone of the scene; the first by default.")
    private String drone;

    /**
     * The name of the drone.
     *
     * @throws InputException when the scene has no such drone, or none at all
     */
    public String of(SceneSettings settings) {
        String first =
                FieldRequest.firstDrone(settings).orElseThrow(() -> new InputException("the scene has no drone"));
        String id = drone == null ? first : drone;
        if (!settings.individualDrones().containsKey(id)) {
            throw new InputException(GivenOption.words("--drone", id) + ": no such drone; the scene has "
                    + String.join(", ", settings.individualDrones().keySet()));
        }
        return id;
    }
}

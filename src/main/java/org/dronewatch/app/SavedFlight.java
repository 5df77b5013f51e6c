package org.dronewatch.app;

import org.dronewatch.flight.Airframe;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.SteeredFlight;
import org.dronewatch.flight.mission.PlanWriter;
import org.dronewatch.geo.Origin;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Spelling;
import org.dronewatch.world.Places;

/** The flight of a scene's drone as a mission. */
final class SavedFlight {
    private SavedFlight() {}

    /**
     * The mission.
     *
     * @param drone id of an individual drone
     * @throws InputException when there is no such drone, it is steered, or the scene has no origin
     */
    static PlanWriter.Written of(SceneSettings settings, String drone, SceneRunner runner) {
        if (!settings.individualDrones().containsKey(drone)) {
            throw new InputException("--flight " + drone + ": there is no such drone; "
                    + Spelling.closestMatches(drone, settings.individualDrones().keySet()));
        }
        Origin origin = settings.world()
                .origin()
                .orElseThrow(() -> new InputException("--flight " + drone
                        + ": the scene needs a world.origin, the latitude and longitude of x = y = 0"));
        Stage stage = runner.stage(settings);
        FlightPath path = stage.flight(drone);
        if (SteeredFlight.in(path).isPresent()) {
            throw new InputException("--flight " + drone
                    + ": is steered during the run: run the scene, and use a 'recorded' flight from its flights.csv");
        }
        boolean isWinged = settings.individualDrones().get(drone).airframe() == Airframe.FIXED_WING;
        Places places = new Places(settings.world(), stage.world()::newGround);
        return new PlanWriter(origin, places, isWinged)
                .write(path, settings.run().duration());
    }
}

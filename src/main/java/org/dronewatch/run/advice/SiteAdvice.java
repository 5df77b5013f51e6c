package org.dronewatch.run.advice;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.dronewatch.buildings.BuildingSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.SweptValue;
import org.dronewatch.scenario.advice.AngleAdvice;
import org.dronewatch.scenario.advice.LightAdvice;
import org.dronewatch.scenario.advice.OriginAdvice;
import org.dronewatch.scenario.advice.PositionerAdvice;
import org.dronewatch.scenario.advice.SoundAdvice;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.SoundTracing;
import org.dronewatch.setting.Switchable;
import org.dronewatch.setting.input.PackagedSite;
import org.dronewatch.terrain.ElevationSurface;
import org.dronewatch.world.Clearance;
import org.dronewatch.world.NoiseSource;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.World;

/**
 * Warns of settings that are allowed but do not fit the site: sensors inside walls or on surfaces, materials without
 * an acoustic surface, positioners that will not work as intended.
 */
public record SiteAdvice(SceneSettings settings, World world) {
    private static final String IN_WALL =
            " seems to be inside a wall or under the ground: most surfaces around it face away from it";

    /** Gives one line for each warning. */
    public void giveTo(Consumer<String> target) {
        settings.world().origin().ifPresent(origin -> new OriginAdvice(origin).giveTo(target));
        onAngles(target);
        onSurfaces(target);
        onTerrain(target);
        new LightAdvice(settings.world().light()).giveTo(target);
        if (isListening()) {
            settings.drones().forEach((id, drone) -> new SoundAdvice(id, drone).giveTo(target));
        }
        if (!settings.world().noiseSources().isEmpty() && !isListening()) {
            target.accept("world.noiseSources has no effect: no acoustic sensor is switched on");
        }
        if (isListening()) {
            settings.world().noiseSources().forEach((id, source) -> onNoiseSource(id, source, target));
        }
        settings.enabledSensors().forEach((id, sensor) -> Mounted.positioner(sensor)
                .ifPresent(positioner -> new PositionerAdvice(settings, id, positioner).giveTo(target)));
        if (settings.enabledSensors().isEmpty() && !settings.sensors().isEmpty()) {
            target.accept(switchedBy() + "all sensors are switched off: nothing is observed");
        }
        Clearance clearance = new Clearance(world);
        settings.enabledSensors().forEach((id, sensor) -> onPosition(id, sensor, clearance, target));
    }

    private void onAngles(Consumer<String> target) {
        settings.enabledSensors().forEach((id, sensor) -> {
            if (sensor instanceof Record record) {
                new AngleAdvice("sensors." + id, record).giveTo(target);
            }
        });
        settings.individualDrones().forEach((id, drone) -> new AngleAdvice("drones." + id, drone).giveTo(target));
    }

    private void onSurfaces(Consumer<String> target) {
        SurfaceSettings surfaces = settings.world().surfaces();
        List<String> leftOver = surfaces.leftOver(world.materialNames());
        if (!leftOver.isEmpty() && isListening()) {
            target.accept("no acoustic surface is assigned to " + String.join(", ", leftOver) + ": treated as '"
                    + surfaces.defaultSurface() + "'; world.surfaces.materials can assign other surfaces");
        }
        List<String> unmatched = surfaces.unmatched(world.materialNames());
        if (!unmatched.isEmpty()) {
            target.accept("world.surfaces.materials: the models have no material named "
                    + String.join(" or ", unmatched) + "; they have " + String.join(", ", world.materialNames()));
        }
        surfaces.unused(world.materialNames())
                .forEach(name -> target.accept("world.surfaces.own." + name
                        + " has no effect: no material of the models uses this surface; the materials are "
                        + String.join(", ", world.materialNames())));
    }

    /** Warns if the heights of the terrain may include roofs that the scene's buildings also include. */
    private void onTerrain(Consumer<String> target) {
        List<String> buildings = new ArrayList<>();
        settings.world()
                .buildings()
                .flatMap(BuildingSettings::file)
                .map(PackagedSite::plain)
                .ifPresent(buildings::add);
        settings.world().models().stream()
                .filter(model -> model.role() == ModelRole.BUILDING)
                .map(ModelSettings::shownFile)
                .forEach(buildings::add);
        boolean hasRoofs =
                settings.world().terrain().stream().anyMatch(terrain -> terrain.surface() == ElevationSurface.DSM);
        if (hasRoofs && !buildings.isEmpty()) {
            target.accept("world.terrain.surface is dsm: its heights may include roofs, which are also in "
                    + String.join(", ", buildings));
        }
    }

    private void onNoiseSource(String id, NoiseSource source, Consumer<String> target) {
        source.positions().stream()
                .filter(world::isInsideWall)
                .findFirst()
                .ifPresent(at -> target.accept("world.noiseSources." + id + " at " + inWords(at) + IN_WALL));
    }

    private boolean isListening() {
        return settings.enabledSensors().values().stream()
                .anyMatch(sensor -> sensor.as(SoundTracing.class).isPresent());
    }

    /** The swept setting, if it is a switch: then other runs of the scene may have sensors. */
    private String switchedBy() {
        return settings.sweep()
                .filter(sweep -> sweep.parameter().endsWith("." + Switchable.ENABLED))
                .map(sweep -> "with " + new SweptValue(settings, sweep).text() + " ")
                .orElse("");
    }

    private void onPosition(String id, SensorSettings<?> sensor, Clearance clearance, Consumer<String> target) {
        Position at = sensor.position();
        String where = "sensor '" + id + "' at " + inWords(at);
        if (world.isInsideWall(at)) {
            target.accept(where + IN_WALL);
        } else if (sensor.as(SoundTracing.class).isEmpty() && clearance.isOnSurface(at)) {
            target.accept(
                    where + " lies on a surface, which may hide everything from it: move the sensor a millimetre away");
        }
    }

    private static String inWords(Position at) {
        return String.format(Locale.ROOT, "(%.3f, %.3f, %.3f) m", at.x(), at.y(), at.z());
    }
}

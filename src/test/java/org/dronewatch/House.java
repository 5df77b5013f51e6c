package org.dronewatch;

import java.util.ArrayList;
import java.util.List;

/** The rooms of the house, which are packages, and the one direction in which they may know each other: downwards. */
public final class House {
    /** What all rooms' names begin with. */
    public static final String NAME = "org.dronewatch.";

    /** The rooms on the storeys from the roof to the ground floor. */
    public static final List<Storey> STOREYS = List.of(
            new Storey("for people", "app.."),
            new Storey("", "viewer.."),
            new Storey("results", "report.."),
            new Storey("", "placement.route"),
            new Storey("", "placement.site"),
            new Storey("", "placement.plan"),
            new Storey("", "bench..", "models..", "render..", "campaign..", "placement.solver", "route.proof"),
            new Storey("", "placement", "route"),
            new Storey("questions", "analysis..", "scenes..", "route.search"),
            new Storey("", "route.exposure"),
            new Storey("a run", "scene"),
            new Storey("", "run"),
            new Storey("", "run.advice"),
            new Storey("", "run.model", "run.time"),
            new Storey("what was prepared", "run.store"),
            new Storey("what is run", "scenario.advice"),
            new Storey("", "scenario"),
            new Storey("", "catalog"),
            new Storey("alerts", "fusion"),
            new Storey("", "tracking"),
            new Storey(
                    "what senses",
                    "sensor.camera..",
                    "sensor.thermal..",
                    "sensor.radar..",
                    "sensor.rf..",
                    "sensor.acoustic.."),
            new Storey("", "sensor.optics", "sensor.radio"),
            new Storey("", "sensor.alarm"),
            new Storey("", "sensor"),
            new Storey("", "positioner"),
            new Storey("what flies", "drone"),
            new Storey("", "drone.silhouette"),
            new Storey("", "flight.mission", "flight.track"),
            new Storey("", "flight.file"),
            new Storey("", "flight"),
            new Storey("the site", "world"),
            new Storey("", "buildings"),
            new Storey("", "buildings.land"),
            new Storey("", "terrain", "buildings.io"),
            new Storey("", "terrain.io"),
            new Storey("", "geo.features"),
            new Storey("", "mesh.io"),
            new Storey("", "mesh.polygon", "geo"),
            new Storey("the ray kernel", "bvh", "raster"),
            new Storey("", "kdtree"),
            new Storey("the ground", "sound", "sound.surface", "statistics", "geometry", "parallel", "setting.."));

    private House() {}

    /**
     * Rooms side by side.
     *
     * @param caption what this storey and those below it without a caption are about
     * @param rooms patterns of packages without the house's name
     */
    public record Storey(String caption, List<String> rooms) {
        Storey(String caption, String... rooms) {
            this(caption, List.of(rooms));
        }
    }

    /**
     * The rooms that the classes of a room may not use: those above it, and those beside it unless it is on the ground
     * floor.
     */
    static List<String> forbidden(Storey storey, String room) {
        List<String> forbidden = new ArrayList<>();
        int number = STOREYS.indexOf(storey);
        for (Storey above : STOREYS.subList(0, number)) {
            forbidden.addAll(above.rooms());
        }
        if (number < STOREYS.size() - 1) {
            storey.rooms().stream().filter(other -> !other.equals(room)).forEach(forbidden::add);
        }
        return forbidden;
    }
}

package org.dronewatch.fuzz;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;

/** Files of flights and of named places: missions, tracks, logs and maps, damaged. */
final class FlightTarget implements FuzzTarget {
    @Override
    public String name() {
        return "flight";
    }

    @Override
    public FuzzCase generate(Dice dice, long number) {
        return switch ((int) (number % 5)) {
            case 0 -> flight("damaged mission", "plan: a.plan", "a.plan", mission(dice), dice);
            case 1 -> flight("damaged track", "log: a.gpx, heights: surface", "a.gpx", track(dice), dice);
            case 2 -> flight("damaged log", "log: a.csv, heights: start", "a.csv", log(dice), dice);
            case 3 ->
                flight("damaged GeoJSON", "kind: hover, position: {feature: p1}", "scene.geojson", geoJson(dice), dice);
            default -> flight("damaged KML", "kind: hover, position: {feature: p1}", "scene.kml", kml(dice), dice);
        };
    }

    private static FuzzCase flight(String what, String flight, String file, String content, Dice dice) {
        String scene = "world:\n  origin: {latitude: 50 deg, longitude: 14 deg, height: 200}\n"
                + "  models: [packaged:hill.obj]\n"
                + "drones: {a: {model: packaged:quadrotor.obj, flight: {" + flight + "}}}\n";
        byte[] damaged = ByteMutation.of(content.getBytes(StandardCharsets.UTF_8), dice);
        return FuzzCase.of(what, "scene.yaml", scene, "check", "{}/scene.yaml").with(file, damaged);
    }

    private static double near(double degrees, Dice dice) {
        return degrees + 1e-5 * dice.between(-500, 500);
    }

    private static String mission(Dice dice) {
        StringBuilder items = new StringBuilder();
        for (int i = dice.between(1, 6); i > 0; i--) {
            items.append(items.length() == 0 ? "" : ",\n")
                    .append(String.format(
                            Locale.ROOT,
                            "{\"type\": \"SimpleItem\", \"command\": %d, \"frame\": %d, \"autoContinue\": true,"
                                    + " \"params\": [%d, 5, 0, null, %.5f, %.5f, %d]}",
                            dice.pick(16, 16, 16, 17, 19, 20, 21, 22, 82, 93, 178, 201),
                            dice.pick(0, 3, 10),
                            dice.between(0, 3),
                            near(50, dice),
                            near(14, dice),
                            dice.between(0, 150)));
        }
        return "{\"fileType\": \"Plan\", \"mission\": {\"hoverSpeed\": 7, \"plannedHomePosition\": [50, 14, 250],\n"
                + "\"items\": [" + items + "]}}";
    }

    private static String track(Dice dice) {
        StringBuilder text = new StringBuilder("<?xml version=\"1.0\"?>\n<gpx version=\"1.1\"><trk><trkseg>\n");
        for (int i = 0; i < dice.between(1, 20); i++) {
            text.append(String.format(
                    Locale.ROOT,
                    "<trkpt lat=\"%.5f\" lon=\"%.5f\"><ele>%d</ele><time>2026-11-24T03:%02d:00Z</time></trkpt>%n",
                    near(50, dice),
                    near(14, dice),
                    dice.between(0, 100),
                    i));
        }
        return text + "</trkseg></trk></gpx>\n";
    }

    private static String log(Dice dice) {
        StringBuilder text = new StringBuilder("time_s,latitude,longitude,altitude(feet)\n");
        for (int i = 0; i < dice.between(1, 20); i++) {
            text.append(String.format(
                    Locale.ROOT, "%d,%.5f,%.5f,%d%n", 60 * i, near(50, dice), near(14, dice), dice.between(0, 100)));
        }
        return text.toString();
    }

    private static String geoJson(Dice dice) {
        return String.format(
                Locale.ROOT,
                "{\"type\": \"FeatureCollection\", \"features\": [{\"type\": \"Feature\", \"properties\": {\"name\": \"p1\"},"
                        + " \"geometry\": {\"type\": \"Point\", \"coordinates\": [%.5f, %.5f]}}]}",
                near(14, dice),
                near(50, dice));
    }

    private static String kml(Dice dice) {
        return String.format(
                Locale.ROOT,
                "<kml><Document><Placemark><name>p1</name><Point><altitudeMode>relativeToGround</altitudeMode>"
                        + "<coordinates>%.5f,%.5f,%d</coordinates></Point></Placemark></Document></kml>",
                near(14, dice),
                near(50, dice),
                dice.between(0, 100));
    }

    @Override
    public void judge(FuzzCase input, Path directory) {
        Judge.check(CommandRun.of(input.argumentsIn(directory)), directory);
    }
}

package org.dronewatch.models;

/** The smooth shape of the land before water has cut it: hills, spurs, broad noise and a river valley. */
final class Landform {

    /** A rounded hill: centre east and north, height, half widths along its own axes, and the turn of its long axis. */
    private record Hill(double x, double y, double height, double along, double across, double degrees) {

        double at(double px, double py) {
            double turn = StrictMath.toRadians(degrees);
            double cos = StrictMath.cos(turn);
            double sin = StrictMath.sin(turn);
            double u = ((px - x) * cos + (py - y) * sin) / along;
            double v = ((py - y) * cos - (px - x) * sin) / across;
            return height * StrictMath.exp(-0.5 * (u * u + v * v));
        }
    }

    private static final double BASE_METRES = 36;

    private static final double MAIN_HILL_METRES = 92;
    private static final double ROUNDING = 0.12;

    private static final Hill[] HILLS = {
        new Hill(-210, -110, 16, 130, 55, 30),
        new Hill(200, -120, 14, 130, 50, -35),
        new Hill(-440, 260, 44, 210, 80, 55),
        new Hill(430, 310, 50, 200, 85, -35),
        new Hill(330, -510, 48, 240, 95, 15),
        new Hill(-380, -540, 40, 180, 110, -20),
        new Hill(690, -120, 44, 110, 190, 10),
        new Hill(-90, 690, 30, 260, 90, 5),
        new Hill(-730, -160, 40, 100, 190, -10),
    };

    private final ValueNoise warp = new ValueNoise(0x5eed01);
    private final ValueNoise swell = new ValueNoise(0x5eed02);
    private final ValueNoise crest = new ValueNoise(0x5eed03);

    /** The height, metres, at a point given in metres east and north of the plan origin. */
    double height(double east, double north) {
        double x = east + 45 * warp.octaves(east / 210, north / 210, 3);
        double y = north + 45 * warp.octaves(east / 210 + 71, north / 210 - 43, 3);
        double height = BASE_METRES + 11 * swell.octaves(x / 260, y / 260, 4) + 7 * ridges(x, y);
        height += MAIN_HILL_METRES * mainHill(x, y);
        for (Hill hill : HILLS) {
            height += hill.at(x, y);
        }
        return height - riverValley(x, y);
    }

    /**
     * The main hill has concave flanks: steep near the top and gentler outward, so that its foot is seen from the top.
     */
    private static double mainHill(double x, double y) {
        double u = (0.94 * x + 0.34 * y) / 260;
        double v = (0.94 * y - 0.34 * x) / 215;
        return StrictMath.exp(ROUNDING - StrictMath.sqrt(u * u + v * v + ROUNDING * ROUNDING));
    }

    /** Folding the noise at zero turns its zero lines into sharp crests. */
    private double ridges(double x, double y) {
        double folded = 1 - Math.abs(crest.octaves(x / 170, y / 170, 3)) * 2;
        return folded * Math.abs(folded);
    }

    /** Depth of the valley that winds from the north-west corner around the south of the hill to the east. */
    private static double riverValley(double x, double y) {
        double course = -330 - 0.00055 * (x + 40) * (x + 40) * StrictMath.tanh(x / 300) + 55 * StrictMath.sin(x / 120);
        double aside = (y - course) / 85;
        return 26 * StrictMath.exp(-0.5 * aside * aside);
    }
}

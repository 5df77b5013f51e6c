package org.dronewatch.models;

import java.util.List;

/**
 * A quadrotor of about two kilograms: a rounded body with a battery on top, four arms with motors and two-bladed
 * propellers, landing legs on skids, and a stabilised camera below the nose. Its nose points to -z; every part is a
 * closed solid. The parts are laid out roughly and then stretched to the stated size, so that the size is exact.
 */
public final class QuadrotorModel {
    /** Overall width, metres, from propeller tip to propeller tip. */
    public static final double WIDTH_METRES = 0.60;

    /** Overall height, metres, from the skids to the top of the satellite antenna. */
    public static final double HEIGHT_METRES = 0.30;

    /** Overall length, metres. */
    public static final double LENGTH_METRES = 0.40;

    private static final Material SHELL = new Material("shell", 0.82, 0.83, 0.85);

    private static final double MOTOR_X = 0.207;
    private static final double MOTOR_Z = 0.118;
    private static final double ARM_Y = 0.018;
    private static final double PROPELLER_RADIUS = 0.093;

    private final Assembly parts = new Assembly();

    private QuadrotorModel() {}

    /** The finished model, its extent centred on the origin. */
    public static Mesh mesh() {
        QuadrotorModel model = new QuadrotorModel();
        model.addBody();
        model.addRotors();
        model.addLandingGear();
        model.addCamera();
        return model.parts.fitted("quadrotor", new Point(WIDTH_METRES, HEIGHT_METRES, LENGTH_METRES));
    }

    private void addBody() {
        double[][] hull = {
            {-0.176, 0.012, 0.008, -0.010},
            {-0.172, 0.030, 0.019, -0.009},
            {-0.160, 0.052, 0.033, -0.006},
            {-0.130, 0.074, 0.048, -0.002},
            {-0.080, 0.093, 0.064, 0.000},
            {0.000, 0.100, 0.069, 0.001},
            {0.080, 0.092, 0.062, 0.003},
            {0.130, 0.068, 0.045, 0.006},
            {0.158, 0.042, 0.029, 0.008},
            {0.166, 0.020, 0.015, 0.008}
        };
        parts.add("hull", Solids.lengthwise(SHELL, hull, 2.6));
        double[][] battery = {
            {-0.070, 0.034, 0.010, 0.052},
            {-0.064, 0.050, 0.024, 0.056},
            {0.000, 0.054, 0.028, 0.060},
            {0.090, 0.050, 0.024, 0.058},
            {0.098, 0.034, 0.010, 0.054}
        };
        parts.add("battery", Solids.lengthwise(Material.DARK_PLASTIC, battery, 4.0));
        parts.add("antenna_mast", Solids.cylinder(Material.DARK_PLASTIC, new Point(0, 0.07, 0.045), 0.006, 0.042, 12));
        double[][] dome = {{0.030, 0}, {0.034, 0.006}, {0.030, 0.013}, {0.016, 0.018}};
        parts.add("antenna", Solids.turned(SHELL, new Point(0, 0.108, 0.045), dome, 24));
    }

    private void addRotors() {
        int number = 0;
        for (double side : new double[] {-1, 1}) {
            for (double end : new double[] {-1, 1}) {
                number++;
                Point shoulder = new Point(0.055 * side, 0.004, 0.050 * end);
                Point motor = new Point(MOTOR_X * side, ARM_Y, MOTOR_Z * end);
                parts.add("arm_" + number, Solids.taperedTube(SHELL, shoulder, 0.026, motor, 0.0185, 14));
                double[][] housing = {{0.013, 0}, {0.021, 0.006}, {0.022, 0.034}, {0.018, 0.046}, {0.007, 0.050}};
                Point foot = motor.minus(new Point(0, 0.016, 0));
                parts.add("motor_" + number, Solids.turned(Material.METAL, foot, housing, 20));
                Point hub = foot.plus(new Point(0, 0.048, 0));
                parts.add("hub_" + number, Solids.cylinder(Material.DARK_PLASTIC, hub, 0.008, 0.010, 12));
                // Rotors as they happen to stop after landing; neighbours turn in opposite directions.
                double standing = StrictMath.toRadians(new double[] {8, -38, -25, 12}[number - 1]);
                double turn = side * end;
                Point middle = hub.plus(new Point(0, 0.006, 0));
                parts.add(
                        "blade_" + number + "a",
                        Propeller.blade(Material.DARK_PLASTIC, middle, PROPELLER_RADIUS, standing, turn));
                parts.add(
                        "blade_" + number + "b",
                        Propeller.blade(
                                Material.DARK_PLASTIC, middle, PROPELLER_RADIUS, standing + StrictMath.PI, turn));
            }
        }
    }

    private void addLandingGear() {
        int number = 0;
        for (double side : new double[] {-1, 1}) {
            String name = side < 0 ? "left" : "right";
            Point front = new Point(0.128 * side, -0.148, -0.125);
            Point frontEnd = new Point(0.128 * side, -0.136, -0.150);
            Point back = new Point(0.128 * side, -0.148, 0.140);
            parts.add("skid_" + name, Solids.pipe(Material.DARK_PLASTIC, List.of(frontEnd, front, back), 0.0095, 12));
            for (double end : new double[] {-1, 1}) {
                number++;
                Point top = new Point(0.050 * side, -0.026, 0.055 * end);
                Point knee = new Point(0.100 * side, -0.070, 0.072 * end);
                Point foot = new Point(0.128 * side, -0.148, 0.082 * end);
                parts.add("leg_" + number, Solids.pipe(Material.DARK_PLASTIC, List.of(top, knee, foot), 0.0115, 12));
            }
        }
    }

    private void addCamera() {
        parts.add(
                "gimbal_mount", Solids.cylinder(Material.DARK_PLASTIC, new Point(0, -0.074, -0.098), 0.020, 0.040, 16));
        double[][] ball = new double[11][];
        for (int i = 0; i < ball.length; i++) {
            double angle = StrictMath.PI * (i + 0.5) / ball.length;
            ball[i] = new double[] {0.039 * StrictMath.sin(angle), -0.039 * StrictMath.cos(angle)};
        }
        Point centre = new Point(0, -0.092, -0.100);
        parts.add("camera", Solids.turned(SHELL, centre, ball, 24));
        Point lens = centre.minus(new Point(0, 0, 0.033));
        parts.add(
                "lens", Solids.taperedTube(Material.LENS, lens, 0.016, lens.minus(new Point(0, 0, 0.012)), 0.014, 16));
    }
}

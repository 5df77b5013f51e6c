package org.dronewatch.models;

import java.util.List;
import java.util.stream.DoubleStream;

/**
 * A hybrid of glider and multirotor of about four kilograms, a fictitious member of the class of unmanned sailplanes of
 * 2 m wingspan that take off vertically: a slender fuselage, a long narrow wing, a T-tail, and four lift rotors on two
 * booms below the wing. While it glides, the rotors stand still, their blades in line with the booms. Its nose points
 * to -z; every part is a closed solid.
 */
public final class HybridGliderModel {
    /** Span, metres. */
    public static final double SPAN_METRES = 2.00;

    /** Overall height, metres, from the belly to the top of the tail. */
    public static final double HEIGHT_METRES = 0.34;

    /** Overall length, metres. */
    public static final double LENGTH_METRES = 1.16;

    private static final Material SKIN = new Material("composite", 0.86, 0.88, 0.90);

    /** How far the booms are from the middle, metres. */
    private static final double BOOM_X = 0.30;

    private final Assembly parts = new Assembly();

    private HybridGliderModel() {}

    /** The finished model, its extent centred on the origin. */
    public static Mesh mesh() {
        HybridGliderModel model = new HybridGliderModel();
        model.addFuselage();
        model.addWing();
        model.addTail();
        model.addLift();
        return model.parts.fitted("hybrid-glider", new Point(SPAN_METRES, HEIGHT_METRES, LENGTH_METRES));
    }

    private void addFuselage() {
        double[][] hull = {
            {-0.500, 0.006, 0.006, -0.022},
            {-0.490, 0.018, 0.018, -0.020},
            {-0.450, 0.034, 0.036, -0.016},
            {-0.370, 0.048, 0.054, -0.008},
            {-0.250, 0.056, 0.066, 0.000},
            {-0.100, 0.054, 0.064, 0.006},
            {0.040, 0.038, 0.044, 0.014},
            {0.160, 0.022, 0.024, 0.022},
            {0.320, 0.015, 0.016, 0.028},
            {0.560, 0.011, 0.012, 0.032},
            {0.580, 0.006, 0.007, 0.032}
        };
        parts.add("fuselage", Solids.lengthwise(SKIN, hull, 2.0));
    }

    /** NACA 4412, narrow and tapered, flat in the middle and with 5 degrees of dihedral outside the booms. */
    private void addWing() {
        double lift = StrictMath.tan(StrictMath.toRadians(5.0));
        List<Airfoil.Station> stations = DoubleStream.of(-1.0, -0.97, -0.65, -0.35, 0.0, 0.35, 0.65, 0.97, 1.0)
                .mapToObj(x -> {
                    double out = Math.abs(x);
                    double beyond = Math.max(0.0, out - 0.35);
                    double tip = out > 0.98 ? 0.03 : 0.0;
                    double chord = 0.205 - 0.14 * beyond - tip;
                    Point nose = new Point(x, 0.066 + lift * beyond, -0.200 + 0.05 * beyond + 0.6 * tip);
                    return new Airfoil.Station(nose, chord);
                })
                .toList();
        parts.add("wing", new Airfoil(0.04, 0.12).wing(SKIN, stations));
    }

    /** A T-tail. */
    private void addTail() {
        List<Airfoil.Station> upwards = List.of(
                new Airfoil.Station(new Point(0, 0.025, 0.440), 0.160),
                new Airfoil.Station(new Point(0, 0.225, 0.500), 0.110));
        parts.add("fin", Airfoil.TAIL.fin(SKIN, upwards));
        Airfoil.Station tip = new Airfoil.Station(new Point(0.25, 0.225, 0.530), 0.075);
        Airfoil.Station root = new Airfoil.Station(new Point(0, 0.225, 0.505), 0.110);
        parts.add("stabiliser", Airfoil.TAIL.wing(SKIN, List.of(tip.mirrored(), root, tip)));
    }

    private void addLift() {
        int number = 0;
        for (double side : new double[] {-1, 1}) {
            String name = side < 0 ? "left" : "right";
            Point front = new Point(BOOM_X * side, 0.052, -0.400);
            Point back = new Point(BOOM_X * side, 0.052, 0.260);
            parts.add("boom_" + name, Solids.pipe(Material.DARK_PLASTIC, List.of(front, back), 0.012, 14));
            for (Point end : List.of(front, back)) {
                number++;
                Point foot = end.minus(new Point(0, 0.006, end.z() * 0.03));
                double[][] housing = {{0.012, 0}, {0.019, 0.006}, {0.020, 0.028}, {0.016, 0.038}, {0.006, 0.041}};
                parts.add("motor_" + number, Solids.turned(Material.METAL, foot, housing, 20));
                Point hub = foot.plus(new Point(0, 0.044, 0));
                double turn = side * Math.signum(end.z());
                // In line with the boom, so that they resist the air least.
                parts.add(
                        "blade_" + number + "a",
                        Propeller.blade(Material.DARK_PLASTIC, hub, 0.125, 0.5 * StrictMath.PI, turn));
                parts.add(
                        "blade_" + number + "b",
                        Propeller.blade(Material.DARK_PLASTIC, hub, 0.125, 1.5 * StrictMath.PI, turn));
            }
        }
    }
}

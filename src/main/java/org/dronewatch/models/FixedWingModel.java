package org.dronewatch.models;

import java.util.List;
import java.util.stream.DoubleStream;

/**
 * A fixed-wing aircraft of about three kilograms, a fictitious member of the class of hand-launched survey aircraft of
 * 1.5 to 2 m wingspan: a slender fuselage with a two-bladed tractor propeller, a high wing with dihedral, a tail, and a
 * camera below. Its nose points to -z; every part is a closed solid.
 */
public final class FixedWingModel {
    /** Span, metres. */
    public static final double SPAN_METRES = 1.80;

    /** Overall height, metres, from the camera to the top of the fin. */
    public static final double HEIGHT_METRES = 0.36;

    /** Overall length, metres. */
    public static final double LENGTH_METRES = 1.20;

    private static final Material SKIN = new Material("foam", 0.90, 0.90, 0.88);

    private final Assembly parts = new Assembly();

    private FixedWingModel() {}

    /** The finished model, its extent centred on the origin. */
    public static Mesh mesh() {
        FixedWingModel model = new FixedWingModel();
        model.addFuselage();
        model.addWing();
        model.addTail();
        model.addPropeller();
        return model.parts.fitted("fixed-wing", new Point(SPAN_METRES, HEIGHT_METRES, LENGTH_METRES));
    }

    private void addFuselage() {
        double[][] hull = {
            {-0.535, 0.022, 0.022, 0.000},
            {-0.520, 0.034, 0.034, 0.000},
            {-0.450, 0.050, 0.052, -0.002},
            {-0.330, 0.062, 0.070, -0.004},
            {-0.150, 0.066, 0.078, 0.000},
            {0.030, 0.062, 0.072, 0.004},
            {0.180, 0.046, 0.050, 0.014},
            {0.340, 0.028, 0.030, 0.024},
            {0.520, 0.017, 0.020, 0.032},
            {0.620, 0.008, 0.010, 0.034}
        };
        parts.add("fuselage", Solids.lengthwise(SKIN, hull, 2.4));
        double[][] ball = {{0.012, -0.030}, {0.026, -0.022}, {0.032, -0.008}, {0.032, 0.010}, {0.026, 0.030}};
        Point below = new Point(0, -0.086, -0.250);
        parts.add("camera", Solids.turned(Material.DARK_PLASTIC, below, ball, 20));
        Point lens = below.plus(new Point(0, -0.008, -0.028));
        parts.add(
                "lens",
                Solids.taperedTube(Material.LENS, lens, 0.012, lens.plus(new Point(0, -0.004, -0.010)), 0.010, 14));
    }

    /** Two panels in one piece: NACA 2412, tapered towards the tips, 3 degrees of dihedral. */
    private void addWing() {
        double lift = StrictMath.tan(StrictMath.toRadians(3.0));
        List<Airfoil.Station> stations = DoubleStream.of(-0.90, -0.87, -0.50, 0.0, 0.50, 0.87, 0.90)
                .mapToObj(x -> {
                    double out = Math.abs(x);
                    double chord = out > 0.88 ? 0.11 : 0.260 - 0.10 * Math.max(0.0, out - 0.1);
                    double nose = -0.190 + 0.035 * out + (out > 0.88 ? 0.045 : 0.0);
                    return new Airfoil.Station(new Point(x, 0.070 + lift * out, nose), chord);
                })
                .toList();
        parts.add("wing", new Airfoil(0.02, 0.12).wing(SKIN, stations));
    }

    private void addTail() {
        Airfoil.Station tip = new Airfoil.Station(new Point(0.27, 0.040, 0.500), 0.105);
        Airfoil.Station root = new Airfoil.Station(new Point(0, 0.040, 0.450), 0.155);
        parts.add("stabiliser", Airfoil.TAIL.wing(SKIN, List.of(tip.mirrored(), root, tip)));
        List<Airfoil.Station> upwards = List.of(
                new Airfoil.Station(new Point(0, 0.030, 0.430), 0.195),
                new Airfoil.Station(new Point(0, 0.150, 0.490), 0.145),
                new Airfoil.Station(new Point(0, 0.235, 0.540), 0.095));
        parts.add("fin", Airfoil.TAIL.fin(SKIN, upwards));
    }

    /** Stationary: one blade up to the right, one down to the left. */
    private void addPropeller() {
        Point hub = new Point(0, 0, 0);
        double[][] cone = {{0.024, -0.012}, {0.022, 0.006}, {0.015, 0.022}, {0.006, 0.032}};
        parts.add("spinner", forward(Solids.turned(Material.DARK_PLASTIC, hub, cone, 20)));
        for (int blade = 0; blade < 2; blade++) {
            double standing = StrictMath.toRadians(-35.0) + blade * StrictMath.PI;
            parts.add(
                    "blade_" + (blade + 1), forward(Propeller.blade(Material.DARK_PLASTIC, hub, 0.140, standing, 1.0)));
        }
    }

    /** Turns a solid from an upright axis to one that points to the nose. */
    private static Solid forward(Solid upright) {
        return upright.moved(p -> new Point(p.x(), -p.z(), -0.540 - p.y()));
    }
}

package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.geometry.IntersectionHandler;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sound.OctaveBands;

/**
 * The ball about a sensor in which rays are counted: what a ray brings is its energy times the length of its chord; over
 * the ball's volume the sum of that is the mean intensity in the ball. One per thread.
 */
final class ReceiverBall {
    private static final int BANDS = OctaveBands.COUNT;

    private final Position centre;
    private final double radius;
    private final double[] airLoss;
    private final double soundSpeed;
    private final double[] received = new double[BANDS];
    private final DecayCurve decay = new DecayCurve();
    private double ofThisRay;
    private double sum;
    private double squares;
    private long rays;

    /**
     * A ball.
     *
     * @param airLoss exponents of the loss in the air by band, 1/m
     * @param soundSpeed m/s
     */
    ReceiverBall(Position centre, double radius, double[] airLoss, double soundSpeed) {
        this.centre = centre;
        this.radius = radius;
        this.airLoss = airLoss;
        this.soundSpeed = soundSpeed;
    }

    void clear() {
        Arrays.fill(received, 0.0);
        decay.clear();
        ofThisRay = 0.0;
        sum = 0.0;
        squares = 0.0;
        rays = 0;
    }

    /** Counts what a ray brings on its way to {@code end} metres from its origin, if it comes by. */
    void count(AcousticRay ray, double[] energy, double end) {
        double entry = IntersectionHandler.raySphere(
                ray.originX,
                ray.originY,
                ray.originZ,
                ray.directionX,
                ray.directionY,
                ray.directionZ,
                centre.x(),
                centre.y(),
                centre.z(),
                radius);
        if (entry >= end) {
            return;
        }
        double x = centre.x() - ray.originX;
        double y = centre.y() - ray.originY;
        double z = centre.z() - ray.originZ;
        double middle = x * ray.directionX + y * ray.directionY + z * ray.directionZ;
        double besideSquared = Math.max(0.0, x * x + y * y + z * z - middle * middle);
        double exit = Math.min(end, middle + Math.sqrt(Math.max(0.0, radius * radius - besideSquared)));
        double at = 0.5 * (entry + exit);
        double brought = 0.0;
        for (int band = 0; band < BANDS; band++) {
            double inBand = energy[band] * Math.exp(-airLoss[band] * at) * (exit - entry);
            received[band] += inBand;
            brought += inBand;
        }
        ofThisRay += brought;
        decay.add((ray.travelled + at) / soundSpeed, brought);
    }

    /** Notes that a ray from the source has come to its end: rays are what scatters independently. */
    void endRay() {
        sum += ofThisRay;
        squares += ofThisRay * ofThisRay;
        ofThisRay = 0.0;
        rays++;
    }

    /** Adds to the decay what was heard on an exact path, as intensity over the source's power. */
    void addExact(double way, double intensity) {
        decay.add(way / soundSpeed, intensity * volume());
    }

    /** Mean intensity in the ball by band, over the source's power, 1/m2. */
    double[] intensities() {
        return Arrays.stream(received).map(brought -> brought / volume()).toArray();
    }

    /** Standard error of the sum of all intensities. */
    double standardError() {
        return Math.sqrt(Math.max(0.0, squares - sum * sum / rays)) / volume();
    }

    /** How the sound dies away; keeps its own figures. */
    DecayCurve decay() {
        return decay.copy();
    }

    private double volume() {
        return 4.0 / 3.0 * Math.PI * radius * radius * radius;
    }
}

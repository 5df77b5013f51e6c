package org.dronewatch.flight;

import org.dronewatch.geometry.Position;

/**
 * The type of airframe, which determines how a drone tilts while it accelerates. Drag and the angle of attack are left
 * out.
 */
public enum Airframe {
    /**
     * Rotors with a thrust along the drone's vertical axis: the drone tilts until the thrust per unit of mass is the
     * acceleration minus gravity (vectors). In level flight with the acceleration a, the tilt from the vertical is
     * given by {@code tan(tilt) = a / g}, towards the acceleration, where g is {@link #GRAVITY}.
     */
    MULTIROTOR {
        @Override
        Attitude lean(double yaw, Position velocity, Position force) {
            Position thrust = Attitude.level(yaw).toDrone(force);
            if (force.length() < WEIGHTLESS) {
                return Attitude.level(yaw);
            }
            return new Attitude(
                    yaw,
                    Math.atan2(-thrust.y(), thrust.z()),
                    Math.atan2(thrust.x(), Math.hypot(thrust.y(), thrust.z())));
        }
    },
    /**
     * A fixed wing: the nose follows the path up and down, and the drone banks so that the force on it other than
     * gravity has no component along its wings, as in a coordinated turn. In level flight at the speed v and the rate
     * of turn omega, the bank angle is given by {@code tan(bank) = v omega / g}, where g is {@link #GRAVITY}.
     */
    FIXED_WING {
        @Override
        Attitude lean(double yaw, Position velocity, Position force) {
            double climb = Math.atan2(velocity.z(), Math.hypot(velocity.x(), velocity.y()));
            Position lift = new Attitude(yaw, climb, 0.0).toDrone(force);
            double bank = Math.hypot(lift.x(), lift.z()) < WEIGHTLESS ? 0.0 : Math.atan2(lift.x(), lift.z());
            return new Attitude(yaw, climb, bank);
        }
    },
    /**
     * A fixed wing with rotors for take-off, hover and landing: the drone tilts like a fixed-wing aircraft while its
     * horizontal speed exceeds its vertical speed, and otherwise like a multirotor.
     */
    HYBRID {
        @Override
        Attitude lean(double yaw, Position velocity, Position force) {
            boolean flying = Math.hypot(velocity.x(), velocity.y()) > Math.abs(velocity.z());
            return (flying ? FIXED_WING : MULTIROTOR).lean(yaw, velocity, force);
        }
    };

    /** Standard acceleration of gravity, m/s2 (3rd General Conference on Weights and Measures, 1901). */
    public static final double GRAVITY = 9.806_65;

    /**
     * Below this force per unit of mass, N/kg, the direction of the force would consist of rounding errors: the drone
     * stays level.
     */
    private static final double WEIGHTLESS = 1e-6;

    /**
     * The attitude for an acceleration.
     *
     * @param yaw heading of the nose, which does not change, rad
     * @param velocity velocity of the drone, m/s
     * @param force specific force: acceleration minus gravity, m/s2
     */
    abstract Attitude lean(double yaw, Position velocity, Position force);

    /**
     * The given path, flown with the tilt of a drone of this type: the positions, velocities and headings are the same,
     * and pitch and roll follow from velocity and {@linkplain FlightPath#acceleration acceleration}. A pitch or roll
     * that the path itself states is kept. The tilt is not limited.
     */
    public FlightPath leaning(FlightPath path) {
        return new LeaningPath(path, this);
    }
}

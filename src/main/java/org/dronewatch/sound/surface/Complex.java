package org.dronewatch.sound.surface;

/** A complex number. */
record Complex(double re, double im) {
    static final Complex ONE = new Complex(1.0, 0.0);

    Complex plus(Complex other) {
        return new Complex(re + other.re, im + other.im);
    }

    Complex minus(Complex other) {
        return new Complex(re - other.re, im - other.im);
    }

    Complex plus(double real) {
        return new Complex(re + real, im);
    }

    Complex times(Complex other) {
        return new Complex(re * other.re - im * other.im, re * other.im + im * other.re);
    }

    Complex times(double factor) {
        return new Complex(re * factor, im * factor);
    }

    /** This number times the imaginary unit. */
    Complex timesI() {
        return new Complex(-im, re);
    }

    Complex over(Complex other) {
        double squared = other.re * other.re + other.im * other.im;
        return new Complex((re * other.re + im * other.im) / squared, (im * other.re - re * other.im) / squared);
    }

    Complex exp() {
        double size = Math.exp(re);
        return new Complex(size * Math.cos(im), size * Math.sin(im));
    }

    double absolute() {
        return Math.hypot(re, im);
    }
}

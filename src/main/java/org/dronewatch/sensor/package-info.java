/**
 * What all kinds of sensors have in common: settings and their capabilities, looks, observations, assessments and
 * detections.
 */
package org.dronewatch.sensor;

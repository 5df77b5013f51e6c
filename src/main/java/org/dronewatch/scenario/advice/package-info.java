/** Hints about settings that are valid, but probably not what was meant. */
package org.dronewatch.scenario.advice;

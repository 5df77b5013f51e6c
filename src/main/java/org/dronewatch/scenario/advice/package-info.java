/** Hints about settings that are valid, but hardly what was meant. */
package org.dronewatch.scenario.advice;

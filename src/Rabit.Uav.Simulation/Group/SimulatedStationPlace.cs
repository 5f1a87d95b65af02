namespace Rabit.Uav.Simulation;

/// <summary>Where a simulated ground station stands. Immutable.</summary>
/// <param name="NorthMetres">From the start of the first vehicle to the north.</param>
/// <param name="EastMetres">To the east.</param>
public sealed record SimulatedStationPlace(double NorthMetres, double EastMetres);

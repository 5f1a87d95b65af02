using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>What a vehicle answered to a command of a simulated ground station. Immutable.</summary>
/// <param name="SystemId">The vehicle.</param>
/// <param name="Result">Its result; null while it has not answered, or where it never did.</param>
public sealed record StationAnswer(byte SystemId, MavResult? Result);

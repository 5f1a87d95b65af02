using System;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace UavConsole.Tests.Abandoned;

/// <summary>Arms the vehicle and takes off, and commands nothing more: a flight whose program has died.</summary>
internal sealed class LiftManager : RabitManager
{
    private readonly QueueSender<VehicleCommand> _commands;
    private readonly MessageSubscriber<VehicleState> _vehicle;
    private TimeSpan _next = TimeSpan.FromSeconds(10);
    private long _id;

    public LiftManager()
        : base("lift")
    {
        _commands = Send<VehicleCommand>(MessageNames.VehicleCommands);
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState);
        WakeUpDelay = TimeSpan.FromMilliseconds(500);
    }

    protected override void ExecuteUnitOfWork()
    {
        _vehicle.Fetch();
        if (Now < _next || _vehicle.Value.LandedState == MavLandedState.InAir)
            return;
        _next = Now + TimeSpan.FromSeconds(4);
        _commands.Push(new VehicleCommand
        {
            Id = ++_id,
            Kind = _vehicle.Value.IsArmed ? VehicleCommandKind.TakeOff : VehicleCommandKind.Arm,
            HeightAboveHomeMetres = 20,
        });
    }
}

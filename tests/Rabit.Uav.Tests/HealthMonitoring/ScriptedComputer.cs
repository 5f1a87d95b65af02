using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>A computer with the figures of a test, looked at once a second.</summary>
internal sealed class ScriptedComputer : IReaderSource<ComputerStatus>
{
    private ReaderContext _context = null!;
    private TimeSpan _due;

    public bool Blocks => false;

    /// <summary>Whether it is looked at: a disk that hangs holds it up.</summary>
    public bool Hangs { get; set; }

    public ComputerStatus Status { get; set; } = ComputerStatus.Unknown;

    public void Open(ReaderContext context) => _context = context;

    public ReaderStep Read(out ComputerStatus value)
    {
        value = Status;
        value.Time = _context.Now;
        if (_context.Now < _due)
            return ReaderStep.WaitUntil(_due);
        _due = _context.Now + TimeSpan.FromSeconds(1);
        return Hangs ? ReaderStep.WaitUntil(_due) : ReaderStep.Value;
    }

    public void Unblock()
    {
    }

    public void Close()
    {
    }
}

using System;

namespace Rabit.Hosting;

/// <summary>The exit code of the process: the highest of all reactors. Any thread.</summary>
internal sealed class ExitCode(Action<int>? set = null)
{
    private readonly Action<int> _set = set ?? (code => Environment.ExitCode = code);
    private readonly object _gate = new();
    private int _highest;   // under _gate

    public void Report(int code)
    {
        lock (_gate)
        {
            if (code <= _highest)
                return;
            _highest = code;
            _set(code);
        }
    }
}

using System.Threading;

namespace Rabit.Uav.Web.Serving;

/// <summary>Counts; any thread.</summary>
internal sealed class PageCounters
{
    private readonly Lock _gate = new();   // guards all below
    private LivePageCounters _counters;

    public delegate void Change(ref LivePageCounters counters);

    public LivePageCounters Value
    {
        get
        {
            lock (_gate)
                return _counters;
        }
    }

    public void Count(Change change)
    {
        lock (_gate)
            change(ref _counters);
    }

    public void CountMessage(int length) => Count((ref LivePageCounters c) =>
    {
        c.Messages++;
        c.MessageBytes += length;
        c.MaxMessageBytes = System.Math.Max(c.MaxMessageBytes, length);
    });

    /// <summary>Takes a place among the browsers that watch.</summary>
    /// <returns>Whether there was one.</returns>
    public bool TryAddBrowser(int max)
    {
        lock (_gate)
        {
            if (_counters.Browsers >= max)
            {
                _counters.BrowsersRefused++;
                return false;
            }

            _counters.Browsers++;
            return true;
        }
    }
}
